"""The encodings that one session reads."""

from collections.abc import Mapping
from types import MappingProxyType

from captra.categories import Category
from captra.observations import Observation
from captra.segmentation import Segmentation
from service.camera import Camera
from service.codecs.depth import depth_codecs
from service.codecs.frames import Frame, FrameCodec
from service.codecs.masks import NO_MASKS, MaskReader, mask_reader
from service.codecs.packed import packed_codecs
from service.codecs.point_cloud2 import PointCloud2Codec
from service.envelopes import Envelope
from service.rejections import PayloadTooLargeError, UnknownEncodingError


class Codecs:
    """Turns messages of every encoding that a session reads into observations."""

    def __init__(self, codecs: tuple[FrameCodec, ...], max_payload_bytes: int, masks: MaskReader = NO_MASKS) -> None:
        self._codecs: Mapping[str, FrameCodec] = MappingProxyType({codec.encoding: codec for codec in codecs})
        self._max_payload_bytes = max_payload_bytes
        self._masks = masks

    @property
    def encodings(self) -> tuple[str, ...]:
        """Media types, the preferred one first."""
        return tuple(self._codecs)

    def check_size(self, payload_bytes: int) -> None:
        """Refuse a payload before it is copied.

        Raises:
            PayloadTooLargeError: it is over the limit.
        """
        if payload_bytes > self._max_payload_bytes:
            raise PayloadTooLargeError(
                f"the cloud has {payload_bytes} bytes or more, the limit is {self._max_payload_bytes}: "
                "crop or thin it out before sending"
            )

    def open(self, envelope: Envelope) -> tuple[Frame, bytes]:
        """Read the header; what follows it in the attachment is the frame's mask or box.

        Raises:
            FrameRejectedError: the encoding is not read here, or the header is missing or malformed.
        """
        envelope, mask = self._masks.split(envelope)
        return self.find(envelope.encoding).open(envelope), mask

    def segmentation(self, mask: bytes, observation: Observation) -> Segmentation:
        """What a mask or box tells of an observation.

        Raises:
            MalformedMaskError: it cannot be read, or does not fit the observation.
        """
        return self._masks.read(mask, observation.shape)

    def find(self, encoding: str) -> FrameCodec:
        """The strategy for an encoding; its parameters are ignored.

        Raises:
            UnknownEncodingError: with the encodings that are read.
        """
        media_type = encoding.partition(";")[0].strip().lower()
        try:
            return self._codecs[media_type]
        except KeyError:
            known = ", ".join(self._codecs)
            raise UnknownEncodingError(
                f"this session does not read {encoding[:100]!r}: use one of {known}; depth images are read by sessions "
                "that were opened with a camera"
            ) from None


def build_codecs(
    max_points: int,
    max_payload_bytes: int,
    category: Category | None = None,
    camera: Camera | None = None,
    masks: str | None = None,
) -> Codecs:
    """Clouds, as every session reads them; depth images and masks where the session was opened for them."""
    images = () if camera is None else depth_codecs(camera, max_points)
    reader = NO_MASKS if masks is None or category is None else mask_reader(masks, category)
    return Codecs((*packed_codecs(max_points), PointCloud2Codec(max_points), *images), max_payload_bytes, reader)
