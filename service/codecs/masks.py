"""What tells object from background without CoordinateNet: a mask image or a bounding box that travels with a frame.

It follows the sixteen bytes of number and stamp in the attachment, so that a frame and its mask cannot be parted.
"""

import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Protocol

import numpy as np
from jaxtyping import UInt8

from captra.categories import Category
from captra.depth_images import Intrinsics
from captra.segmentation import BACKGROUND, NOTHING_KNOWN, OBJECT, Box, LabelImage, Segmentation
from service.camera import Camera
from service.codecs.depth import read_png
from service.envelopes import ATTACHMENT, Envelope
from service.rejections import FrameRejectedError, MalformedMaskError, WrongImageSizeError

BOX = struct.Struct("<4H")
"""First column, first row, and the column and row behind the last ones."""
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"

Shape = tuple[int, int]
Meaning = Callable[[UInt8[np.ndarray, "rows columns"]], UInt8[np.ndarray, "rows columns"]]


class MaskReader(Protocol):
    """What a session takes beside its frames."""

    def split(self, envelope: Envelope) -> tuple[Envelope, bytes]:
        """The envelope without its mask, and the mask; raises MalformedMaskError where none is read."""

    def read(self, mask: bytes, shape: Shape) -> Segmentation:
        """What a mask tells of an observation of so many rows and columns; raises MalformedMaskError."""


class NoMasks:
    """CoordinateNet decides, always."""

    def split(self, envelope: Envelope) -> tuple[Envelope, bytes]:
        """Nothing to take off.

        Raises:
            MalformedMaskError: there is a mask or a box all the same.
        """
        if _parted(envelope)[1]:
            raise MalformedMaskError(
                'a mask or box came with the frame, but the session was opened without: open it with masks "object" or '
                '"parts", or send the frame alone'
            )
        return envelope, b""

    def read(self, mask: bytes, shape: Shape) -> Segmentation:  # noqa: ARG002 - asked for by the protocol
        """Nothing."""
        return NOTHING_KNOWN


def _parted(envelope: Envelope) -> tuple[Envelope, bytes]:
    """Whatever begins like a mask, or is as long as a box, behind the sixteen bytes."""
    attachment = envelope.attachment or b""
    head, tail = attachment[: ATTACHMENT.size], attachment[ATTACHMENT.size :]
    if len(tail) == BOX.size or tail.startswith(PNG_SIGNATURE):
        return replace(envelope, attachment=head), tail
    return envelope, b""


NO_MASKS: MaskReader = NoMasks()


@dataclass(frozen=True)
class Masks:
    """A mask or a box where a frame has one; without, CoordinateNet decides."""

    meaning: Meaning
    """From the image's values to labels."""

    def split(self, envelope: Envelope) -> tuple[Envelope, bytes]:
        """Take it off the attachment."""
        return _parted(envelope)

    def read(self, mask: bytes, shape: Shape) -> Segmentation:
        """Decode.

        Raises:
            MalformedMaskError: the image cannot be read or has another size, or the box is empty.
        """
        if not mask:
            return NOTHING_KNOWN
        if len(mask) == BOX.size:
            return self._box(mask, shape)
        height, width = shape
        camera = Camera(Intrinsics(1, 1, 0, 0), 1.0, width, height)
        try:
            image = read_png(mask, "L", camera, width * height)
        except WrongImageSizeError:
            raise MalformedMaskError(
                f"the mask has other columns or rows than what it goes with, {width} × {height}: one pixel for each of "
                "the image or organized cloud; one row of a list of points"
            ) from None
        except FrameRejectedError as error:
            raise MalformedMaskError(f"the mask is not {width} × {height} pixels of 8-bit grey PNG: {error}") from error
        return LabelImage(self.meaning(image))

    def _box(self, mask: bytes, shape: Shape) -> Segmentation:
        left, top, right, bottom = BOX.unpack(mask)
        rows, columns = shape
        if rows == 1:
            raise MalformedMaskError("a box needs an image or an organized cloud: this cloud is a list of points")
        if not (left < right <= columns and top < bottom <= rows):
            raise MalformedMaskError(
                f"the box from ({left}, {top}) to ({right}, {bottom}) holds no pixel, or reaches out of the "
                f"{columns} × {rows} pixels: left, top, right and bottom, the last two not inside"
            )
        return Box(columns, left, top, right, bottom)


def of_object(image: UInt8[np.ndarray, "rows columns"]) -> UInt8[np.ndarray, "rows columns"]:
    """Zero is background, everything else the object."""
    return np.where(image == 0, np.uint8(BACKGROUND), np.uint8(OBJECT))


def of_parts(category: Category) -> Meaning:
    """Zero is background, 1, 2, … are the category's parts."""

    def labels(image: UInt8[np.ndarray, "rows columns"]) -> UInt8[np.ndarray, "rows columns"]:
        largest = int(image.max())
        if largest > category.num_parts:
            raise MalformedMaskError(
                f"the mask has the value {largest}: {category.name} has {category.num_parts} parts, numbered from 1"
            )
        return image

    return labels


KINDS: Mapping[str, Callable[[Category], Meaning]] = MappingProxyType(
    {"object": lambda category: of_object, "parts": of_parts}  # noqa: ARG005 - of one signature
)
"""By the names that sessions use."""


def mask_reader(kind: str, category: Category) -> MaskReader:
    """The reader for a session that was opened with masks."""
    return Masks(KINDS[kind](category))
