"""Everything the service refuses: each reason is a class, whose name is its slug, and which has an HTTP status.

A slug is the `reason` of problems, events and counters; docs/wire-contract.md lists them all.
"""

import re
from dataclasses import dataclass
from typing import ClassVar


class RejectedError(ValueError):
    """Something that a client sent is refused; whatever it was meant for stays as it was."""

    reason: ClassVar[str]
    status: ClassVar[int] = 422
    title: ClassVar[str]

    def __init__(self, detail: str, looks: int | None = None) -> None:
        """`looks` says how many the refused frame might take, where the tracker has tried it."""
        super().__init__(detail)
        self.looks = looks

    def __init_subclass__(cls, reason: str | None = None, status: int | None = None) -> None:
        """EmptyCloudError has the reason `empty-cloud` and the title "Empty cloud", unless it says otherwise."""
        words = re.findall("[A-Z][a-z]*", cls.__name__.removesuffix("Error"))
        cls.reason = reason or "-".join(words).lower()
        cls.title = cls.reason.replace("-", " ").capitalize()
        cls.status = cls.status if status is None else status

    @property
    def detail(self) -> str:
        """What is wrong with this one, and what to do next."""
        return str(self)


class FrameRejectedError(RejectedError):
    """A frame is refused."""


class UnknownEncodingError(FrameRejectedError, status=415):
    """The session does not read clouds of this encoding."""


class MissingAttachmentError(FrameRejectedError):
    """A cloud came by Zenoh without its attachment."""


class MalformedAttachmentError(FrameRejectedError):
    """The attachment does not have the bytes of a sequence number and a stamp."""


class EmptyCloudError(FrameRejectedError):
    """The cloud has no points, or the message no bytes."""


class WrongByteCountError(FrameRejectedError):
    """The payload is no whole number of points."""


class NotFiniteError(FrameRejectedError):
    """The cloud holds NaN or infinity."""


class CoordinatesOutOfRangeError(FrameRejectedError):
    """A coordinate is beyond anything a camera sees."""


class TooManyPointsError(FrameRejectedError, status=413):
    """The cloud has more points than the service takes."""


class PayloadTooLargeError(FrameRejectedError, status=413):
    """The cloud has more bytes than the service takes."""


class WrongSecretError(FrameRejectedError, status=403):
    """The cloud comes from someone who does not know the session's secret."""


class StaleSeqError(FrameRejectedError, status=409):
    """The frame is older than the last one processed."""


class RepeatedSeqError(FrameRejectedError, status=409):
    """The frame has the number of the last one processed."""


class NoPointsNearObjectError(FrameRejectedError):
    """The cloud holds nothing where the object was."""


class MalformedMessageError(FrameRejectedError):
    """The payload is no ROS message of the type it should be."""


class UnsupportedFieldsError(FrameRejectedError):
    """The cloud has no x, y and z that can be read."""


class MalformedImageError(FrameRejectedError):
    """The payload is no image of the kind it should be."""


class WrongImageSizeError(FrameRejectedError):
    """The image has other columns or rows than the session's camera."""


class MalformedMaskError(FrameRejectedError):
    """The mask or box that came with a frame cannot be used."""


class InternalError(FrameRejectedError, reason="internal-error", status=500):
    """The frame met a defect of the service."""


class RequestRejectedError(RejectedError):
    """A request other than a frame is refused."""


@dataclass(frozen=True)
class Mistake:
    """One thing that is wrong with a request."""

    pointer: str
    """Where: a JSON pointer that begins with /body, /path or /query; empty for the whole."""
    detail: str
    """What is wrong there."""

    def __str__(self) -> str:
        return f"{self.pointer}: {self.detail}" if self.pointer else self.detail


class InvalidRequestError(RequestRejectedError):
    """The body or the query does not have the form that the OpenAPI document describes."""

    def __init__(self, *mistakes: Mistake) -> None:
        """All that is wrong, at least one thing."""
        super().__init__(str(mistakes[0]) + (f" (and {len(mistakes) - 1} more)" if len(mistakes) > 1 else ""))
        self.mistakes = mistakes


class UnknownCategoryError(RequestRejectedError):
    """No category has this name."""


class CategoryWithoutModelError(RequestRejectedError):
    """The category is known, but this service holds no model of it."""


class ModelNotLoadableError(RequestRejectedError, status=503):
    """There is a model of the category, but it cannot be loaded."""


class UnsupportedOptionError(RequestRejectedError):
    """The option is part of the interface, but this version cannot honour it."""


class WrongNumberOfPartsError(RequestRejectedError):
    """The pose has more or fewer parts than the category."""


class NotARotationError(RequestRejectedError):
    """The quaternion is not of unit length, or the matrix is not orthonormal and right-handed."""


class SizeNotPositiveError(RequestRejectedError):
    """A box has an edge of zero or negative length."""


class ImplausiblePoseError(RequestRejectedError):
    """The pose is far beyond what a camera sees: probably not in metres."""


class UnauthorizedError(RequestRejectedError, status=401):
    """The request does not say who calls, or not so that it can be believed."""


class ForbiddenError(RequestRejectedError, status=403):
    """The caller is known, but may not do this."""


class TooManySessionsError(RequestRejectedError, status=429):
    """The service holds as many sessions as it may."""


class TooManyFramesError(RequestRejectedError, status=429):
    """As many frames of the session wait as may."""


class NotStoredError(RequestRejectedError, status=503):
    """The session cannot be kept over a restart, so it is not opened."""


class RecordingsFullError(RequestRejectedError, status=507):
    """There is no room for another recording."""


class UnknownRecordingError(RequestRejectedError, status=404):
    """No recording has this name."""


class UnfinishedRecordingError(RequestRejectedError, status=409):
    """The recording is still being written, or was broken off."""


class UnknownSessionError(RequestRejectedError, status=404):
    """No session has this id, or it is closed."""


class NotFoundError(RequestRejectedError, status=404):
    """The path leads nowhere."""


class MethodNotAllowedError(RequestRejectedError, status=405):
    """The path exists, but not with this method."""


class BodyTooLargeError(RequestRejectedError, status=413):
    """The body is over the limit."""


class SlowBodyError(RequestRejectedError, status=408):
    """The body takes too long to arrive."""


class UnsupportedMediaTypeError(RequestRejectedError, status=415):
    """The body is not JSON."""


class NotReadyError(RequestRejectedError, status=503):
    """The service is starting or stopping."""


class RequestFailedError(RequestRejectedError, reason="internal-error", status=500):
    """The request met a defect of the service."""


class HinderedError(RequestRejectedError, status=503):
    """The service cannot get ready: it has no model, or preparation failed; waiting does not help."""


FRAME_REASONS: tuple[str, ...] = tuple(kind.reason for kind in FrameRejectedError.__subclasses__())
"""Every reason for which a frame is refused."""

REQUEST_REASONS: tuple[str, ...] = tuple(kind.reason for kind in RequestRejectedError.__subclasses__())
"""Every reason for which another request is refused."""
