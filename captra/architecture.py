"""Widths of the networks (paper, appendix; METHOD, "Networks"): what training builds and benchmarks count."""

XYZ = 3
"""Coordinates of a point."""

LEVEL1_CHANNELS = ((32, 32, 64), (64, 64, 128), (64, 96, 128))
"""Of the layers of each radius of the first set-abstraction level."""

LEVEL2_CHANNELS = ((128, 128, 256), (128, 196, 256))
"""Of the second one."""

GLOBAL_CHANNELS = (256, 512, 1024)
"""Of the layers over the whole cloud."""

UP3_CHANNELS, UP2_CHANNELS, UP1_CHANNELS = (256, 256), (256, 128), (128, 128)
"""Of the feature propagations, coarse to fine."""

FEATURES = 128
"""Channels of the backbone's output."""

HEAD_CHANNELS = (512, 512, 256)
"""Of the hidden layers of a rotation head."""
