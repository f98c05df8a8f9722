"""Depth images: 16-bit PNG, and raw 16-bit or float pixels."""

import io
from dataclasses import dataclass

import numpy as np
from PIL import Image

from captra.depth_images import DepthImage, Pixels
from service.camera import Camera
from service.codecs.frames import Frame, FrameCodec
from service.envelopes import Envelope, unpack_attachment
from service.rejections import (
    EmptyCloudError,
    MalformedImageError,
    TooManyPointsError,
    WrongByteCountError,
    WrongImageSizeError,
)

DEPTH_PNG = "image/png"
"""16-bit grey PNG."""
DEPTH_U16 = "application/vnd.captra.depth.u16"
"""Rows of little-endian uint16."""
DEPTH_F32 = "application/vnd.captra.depth.f32"
"""Rows of little-endian float32, metres."""


@dataclass(frozen=True)
class PngDepthCodec:
    """16-bit grey PNG; zero is a pixel without depth."""

    camera: Camera
    """That took the images."""
    max_points: int
    """Larger images are refused."""
    encoding: str = DEPTH_PNG
    """Media type."""

    def open(self, envelope: Envelope) -> Frame:
        """Number and stamp from the attachment."""
        return Frame(unpack_attachment(envelope.attachment), lambda: self.image(envelope.payload))

    def image(self, payload: bytes) -> DepthImage:
        """Decode.

        Raises:
            EmptyCloudError: no bytes.
            MalformedImageError: no 16-bit grey PNG.
            WrongImageSizeError: not of the camera's size.
            TooManyPointsError: over the limit.
        """
        if not payload:
            raise EmptyCloudError("the image has no bytes: send a 16-bit grey PNG")
        pixels = read_png(payload, "I;16", self.camera, self.max_points)
        return DepthImage(pixels, self.camera.metres_per_unit, self.camera.intrinsics)


@dataclass(frozen=True)
class RawDepthCodec:
    """Pixels row by row as they are in memory; zero, negative and non-finite ones have no depth."""

    encoding: str
    """Media type."""
    dtype: np.dtype[np.uint16] | np.dtype[np.float32]
    """Of one pixel."""
    metres_per_unit: float
    """What one unit is worth."""
    camera: Camera
    """That took the images; its size is known."""

    def open(self, envelope: Envelope) -> Frame:
        """Number and stamp from the attachment."""
        return Frame(unpack_attachment(envelope.attachment), lambda: self.image(envelope.payload))

    def image(self, payload: bytes) -> DepthImage:
        """A view of the payload.

        Raises:
            EmptyCloudError: no bytes.
            WrongByteCountError: not as many pixels as the camera has.
        """
        shape = (self.camera.height or 0, self.camera.width or 0)
        expected = shape[0] * shape[1] * self.dtype.itemsize
        if not payload:
            raise EmptyCloudError(f"the image has no bytes: send {expected}")
        if len(payload) != expected:
            raise WrongByteCountError(
                f"the image has {len(payload)} bytes: {shape[1]} × {shape[0]} pixels of {self.encoding} have {expected}"
            )
        pixels: Pixels = np.frombuffer(payload, self.dtype).reshape(shape)
        return DepthImage(pixels, self.metres_per_unit, self.camera.intrinsics)


def depth_codecs(camera: Camera, max_points: int) -> tuple[FrameCodec, ...]:
    """What a session with a camera reads; raw pixels only where their number of columns and rows is known."""
    png = PngDepthCodec(camera, max_points)
    if camera.width is None or camera.height is None:
        return (png,)
    units = RawDepthCodec(DEPTH_U16, np.dtype("<u2"), camera.metres_per_unit, camera)
    return png, units, RawDepthCodec(DEPTH_F32, np.dtype("<f4"), 1.0, camera)


def read_png(payload: bytes, mode: str, camera: Camera, max_points: int) -> np.ndarray:
    """Pixels (rows, columns) of a grey PNG of Pillow's mode "I;16" (uint16) or "L" (uint8), looked at before unpacked.

    Raises:
        MalformedImageError: no such image.
        WrongImageSizeError: not of the camera's size.
        TooManyPointsError: over the limit.
    """
    try:
        with Image.open(io.BytesIO(payload), formats=("PNG",)) as image:
            if image.mode != mode:
                bits = {"I;16": "16", "L": "8"}[mode]
                raise MalformedImageError(f"the PNG has the mode {image.mode}: send {bits}-bit grey ({mode})")
            width, height = image.size
            if (camera.width or width, camera.height or height) != (width, height):
                raise WrongImageSizeError(
                    f"the image has {width} × {height} pixels, the camera {camera.width} × {camera.height}: "
                    "open the session with the size of its images"
                )
            if width * height > max_points:
                raise TooManyPointsError(f"the image has {width * height} pixels, the limit is {max_points}")
            return np.frombuffer(image.tobytes(), "<u2" if mode == "I;16" else "u1").reshape(height, width)
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        if isinstance(error, MalformedImageError | WrongImageSizeError | TooManyPointsError):
            raise
        raise MalformedImageError(f"the payload is no whole PNG image ({error})") from error
