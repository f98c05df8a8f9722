"""Procedural instances of the categories, one module each."""

from captra.data.shapes.mesh import Mesh
from captra.data.shapes.registry import make_shape
from captra.data.shapes.shape import Shape

__all__ = ["Mesh", "Shape", "make_shape"]
