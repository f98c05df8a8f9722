"""Category-level pose tracking from point clouds, without a CAD model."""

__version__ = "0.1.0"
