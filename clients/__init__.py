"""Talking to a running service: the Python client, the recordings player and the command-line tools."""

from clients.clouds import Frame, crop_ball, thin_out
from clients.errors import (
    ClientError,
    FrameRejectedError,
    NoResultError,
    RequestRefusedError,
    ServiceUnreachableError,
    SessionClosedError,
)
from clients.results import Event, JointState, PartPose, Result, Timing
from clients.session import Session, open_session

__all__ = [
    "ClientError",
    "Event",
    "Frame",
    "FrameRejectedError",
    "JointState",
    "NoResultError",
    "PartPose",
    "RequestRefusedError",
    "Result",
    "ServiceUnreachableError",
    "Session",
    "SessionClosedError",
    "Timing",
    "crop_ball",
    "open_session",
    "thin_out",
]
