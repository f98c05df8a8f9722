"""From checkpoints to what is served: ONNX bundles, and the comparison of both."""
