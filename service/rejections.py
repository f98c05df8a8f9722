"""Everything the service refuses: each reason is a class with a slug, an HTTP status and a title.

A slug is the `reason` of problems, events and counters; docs/wire-contract.md lists them all.
"""

from typing import ClassVar


class RejectedError(ValueError):
    """Something that a client sent is refused; whatever it was meant for stays as it was."""

    reason: ClassVar[str]
    status: ClassVar[int]
    title: ClassVar[str]

    @property
    def detail(self) -> str:
        """What is wrong with this one, and what to do next."""
        return str(self)


class FrameRejectedError(RejectedError):
    """A frame is refused."""

    status = 422


class UnknownEncodingError(FrameRejectedError):
    """The session does not read clouds of this encoding."""

    reason, status, title = "unknown-encoding", 415, "Unknown encoding"


class MissingAttachmentError(FrameRejectedError):
    """A cloud came by Zenoh without its attachment."""

    reason, title = "missing-attachment", "Attachment missing"


class MalformedAttachmentError(FrameRejectedError):
    """The attachment does not have the bytes of a sequence number and a stamp."""

    reason, title = "malformed-attachment", "Attachment malformed"


class EmptyCloudError(FrameRejectedError):
    """The cloud has no points."""

    reason, title = "empty-cloud", "Cloud is empty"


class WrongByteCountError(FrameRejectedError):
    """The payload is no whole number of points."""

    reason, title = "wrong-byte-count", "Wrong number of bytes"


class NotFiniteError(FrameRejectedError):
    """The cloud holds NaN or infinity."""

    reason, title = "not-finite", "Coordinates are not finite"


class CoordinatesOutOfRangeError(FrameRejectedError):
    """A coordinate is beyond anything a camera sees."""

    reason, title = "coordinates-out-of-range", "Coordinates out of range"


class TooManyPointsError(FrameRejectedError):
    """The cloud has more points than the service takes."""

    reason, status, title = "too-many-points", 413, "Too many points"


class PayloadTooLargeError(FrameRejectedError):
    """The cloud has more bytes than the service takes."""

    reason, status, title = "payload-too-large", 413, "Payload too large"


class StaleSeqError(FrameRejectedError):
    """The frame is older than the last one processed."""

    reason, status, title = "stale-seq", 409, "Sequence number is stale"


class RepeatedSeqError(FrameRejectedError):
    """The frame has the number of the last one processed."""

    reason, status, title = "repeated-seq", 409, "Sequence number is repeated"


class NoPointsNearObjectError(FrameRejectedError):
    """The cloud holds nothing where the object was."""

    reason, title = "no-points-near-object", "No points near the object"


class InternalError(FrameRejectedError):
    """The frame met a defect of the service."""

    reason, status, title = "internal-error", 500, "Internal error"


class RequestRejectedError(RejectedError):
    """A request other than a frame is refused."""

    status = 422


class InvalidRequestError(RequestRejectedError):
    """The body or the query does not have the form that the OpenAPI document describes."""

    reason, title = "invalid-request", "Request is not valid"


class UnknownCategoryError(RequestRejectedError):
    """No category has this name."""

    reason, title = "unknown-category", "Unknown category"


class CategoryWithoutModelError(RequestRejectedError):
    """The category is known, but this service holds no model of it."""

    reason, title = "category-without-model", "No model for this category"


class ModelNotLoadableError(RequestRejectedError):
    """There is a model of the category, but it cannot be loaded."""

    reason, status, title = "model-not-loadable", 503, "Model cannot be loaded"


class UnsupportedOptionError(RequestRejectedError):
    """The option is part of the interface, but this version cannot honour it."""

    reason, title = "unsupported-option", "Option is not supported yet"


class WrongNumberOfPartsError(RequestRejectedError):
    """The pose has more or fewer parts than the category."""

    reason, title = "wrong-number-of-parts", "Wrong number of parts"


class NotARotationError(RequestRejectedError):
    """The quaternion is not of unit length, or the matrix is not orthonormal and right-handed."""

    reason, title = "not-a-rotation", "Not a rotation"


class SizeNotPositiveError(RequestRejectedError):
    """A box has an edge of zero or negative length."""

    reason, title = "size-not-positive", "Size is not positive"


class ImplausiblePoseError(RequestRejectedError):
    """The pose is far beyond what a camera sees: probably not in metres."""

    reason, title = "implausible-pose", "Pose is implausible"


class TooManySessionsError(RequestRejectedError):
    """The service holds as many sessions as it may."""

    reason, status, title = "too-many-sessions", 429, "Too many sessions"


class UnknownSessionError(RequestRejectedError):
    """No session has this id, or it is closed."""

    reason, status, title = "unknown-session", 404, "Unknown session"


class NotFoundError(RequestRejectedError):
    """The path leads nowhere."""

    reason, status, title = "not-found", 404, "Not found"


class MethodNotAllowedError(RequestRejectedError):
    """The path exists, but not with this method."""

    reason, status, title = "method-not-allowed", 405, "Method not allowed"


class BodyTooLargeError(RequestRejectedError):
    """The body is over the limit."""

    reason, status, title = "body-too-large", 413, "Body too large"


class UnsupportedMediaTypeError(RequestRejectedError):
    """The body is not JSON."""

    reason, status, title = "unsupported-media-type", 415, "Unsupported media type"


class NotReadyError(RequestRejectedError):
    """The service is starting or stopping."""

    reason, status, title = "not-ready", 503, "Not ready"


class HinderedError(RequestRejectedError):
    """The service cannot get ready: it has no model, or preparation failed; waiting does not help."""

    reason, status, title = "hindered", 503, "Hindered"


FRAME_REASONS: tuple[str, ...] = tuple(kind.reason for kind in FrameRejectedError.__subclasses__())
"""Every reason for which a frame is refused."""

REQUEST_REASONS: tuple[str, ...] = tuple(kind.reason for kind in RequestRejectedError.__subclasses__())
"""Every reason for which another request is refused."""
