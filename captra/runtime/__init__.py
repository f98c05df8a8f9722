"""Model bundles and the networks in them, run by ONNX Runtime; needs no PyTorch."""
