"""Frames off the wire: one strategy an encoding, each malformed input with its own reason."""

from service.codecs.catalog import Codecs, build_codecs
from service.codecs.depth import DEPTH_F32, DEPTH_PNG, DEPTH_U16
from service.codecs.packed import CLOUD_F32, CLOUD_I16
from service.codecs.point_cloud2 import CDR

__all__ = ["CDR", "CLOUD_F32", "CLOUD_I16", "DEPTH_F32", "DEPTH_PNG", "DEPTH_U16", "Codecs", "build_codecs"]
