"""Talking to a running service: the Python client, the recordings player and the command-line tools."""

from clients.camera import Camera
from clients.clouds import crop_ball, thin_out
from clients.depth import DepthImage, DepthPng
from clients.errors import (
    ClientError,
    FrameRejectedError,
    NoResultError,
    RequestRefusedError,
    ServiceUnreachableError,
    SessionClosedError,
)
from clients.options import Ros2, Smoothing
from clients.packing import Frame
from clients.point_cloud2 import PointCloud2
from clients.regions import Box, Mask
from clients.results import Event, JointState, PartPose, Result, Timing
from clients.session import Session, open_session

__all__ = [
    "Box",
    "Camera",
    "ClientError",
    "DepthImage",
    "DepthPng",
    "Event",
    "Frame",
    "FrameRejectedError",
    "JointState",
    "Mask",
    "NoResultError",
    "PartPose",
    "PointCloud2",
    "RequestRefusedError",
    "Result",
    "Ros2",
    "ServiceUnreachableError",
    "Session",
    "SessionClosedError",
    "Smoothing",
    "Timing",
    "crop_ball",
    "open_session",
    "thin_out",
]
