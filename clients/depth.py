"""Depth images: pixels as they are in memory, or compressed as a PNG file has them."""

import io
import struct
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float32, UInt16
from PIL import Image

from captra import depth_images
from clients.camera import Camera
from clients.clouds import thin_out
from clients.regions import FASTEST, Box, Region

PNG_HEADER = struct.Struct(">8s4s4sII")
"""Signature, length and name of the first chunk, and its columns and rows."""
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"


@dataclass(frozen=True, eq=False)
class DepthPng:
    """A 16-bit grey PNG of depth along the optical axis, as it is in a file."""

    data: bytes
    """The file."""

    def __post_init__(self) -> None:
        if not self.data.startswith(PNG_SIGNATURE) or len(self.data) < PNG_HEADER.size:
            raise ValueError("these bytes are no PNG image: give the whole file, or the pixels as DepthImage")

    @property
    def media_type(self) -> str:
        """Zenoh's `Encoding`, and `Content-Type` over HTTP."""
        return "image/png"

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        *_, columns, rows = PNG_HEADER.unpack_from(self.data)
        return rows, columns

    def payload(self, camera: Camera | None) -> bytes:
        """The file; raises ValueError where `camera` is missing or has images of another size."""
        check_camera(camera, self.shape)
        return self.data

    def region(self, region: Region) -> bytes:
        """A mask or box as it travels with this image; raises ValueError where it is of another size."""
        return region_bytes(region, self.shape)

    def shown(self, camera: Camera | None) -> np.ndarray:
        """Points (N, 3) for viewers, metres: as many as fit into one message."""
        with Image.open(io.BytesIO(self.data), formats=("PNG",)) as image:
            return points_of(np.asarray(image), camera)


@dataclass(frozen=True, eq=False)
class DepthImage:
    """Depth along the optical axis, pixel by pixel: quick to send on one machine, see `to_png` for networks."""

    pixels: UInt16[np.ndarray, "rows columns"] | Float32[np.ndarray, "rows columns"]
    """uint16 in the camera's units (millimetres unless it says otherwise), or float32 in metres; pixels that are zero,
    negative or not finite have no depth."""

    def __post_init__(self) -> None:
        if self.pixels.dtype not in {np.dtype(np.uint16), np.dtype(np.float32)} or self.pixels.ndim != 2:
            raise ValueError(
                f"a depth image is (rows, columns) in uint16 (the camera's units) or float32 (metres), "
                f"not {self.pixels.dtype} {self.pixels.shape}: use .astype with the one that its values are"
            )

    @property
    def media_type(self) -> str:
        """Zenoh's `Encoding`, and `Content-Type` over HTTP."""
        return f"application/vnd.captra.depth.{'u16' if self.pixels.dtype == np.uint16 else 'f32'}"

    def to_png(self) -> DepthPng:
        """Compressed without loss, to a third or so, within milliseconds: for networks, and for the disk.

        Raises:
            ValueError: the pixels are metres in float32, which a PNG does not hold.
        """
        if self.pixels.dtype != np.uint16:
            raise ValueError("a PNG holds uint16: turn metres into units first, e.g. np.uint16(1000 * metres)")
        buffer = io.BytesIO()
        Image.fromarray(np.ascontiguousarray(self.pixels)).save(buffer, "PNG", compress_level=FASTEST)
        return DepthPng(buffer.getvalue())

    def payload(self, camera: Camera | None) -> bytes:
        """Row by row; raises ValueError where `camera` is missing or has images of another size."""
        check_camera(camera, self.pixels.shape)
        return self.pixels.astype(self.pixels.dtype.newbyteorder("<"), copy=False).tobytes()

    def region(self, region: Region) -> bytes:
        """A mask or box as it travels with this image; raises ValueError where it is of another size."""
        return region_bytes(region, self.pixels.shape)

    def shown(self, camera: Camera | None) -> np.ndarray:
        """Points (N, 3) for viewers, metres: as many as fit into one message."""
        return points_of(self.pixels, camera)


def check_camera(camera: Camera | None, shape: tuple[int, ...]) -> Camera:
    """The camera, where it fits images of so many rows and columns.

    Raises:
        ValueError: it does not, or there is none.
    """
    if camera is None:
        raise ValueError(
            "this session was opened without a camera, so that depth means nothing: "
            "open_session(..., camera=Camera(fx, fy, cx, cy, width, height)) with the intrinsics of the depth images"
        )
    if (camera.height, camera.width) != shape:
        raise ValueError(
            f"the image has {shape[1]} × {shape[0]} pixels, the camera {camera.width} × {camera.height}: open the "
            "session with the size and intrinsics of the images that you send"
        )
    return camera


def region_bytes(region: Region, shape: tuple[int, ...]) -> bytes:
    """A mask or box of an image of so many rows and columns, as it travels.

    Raises:
        ValueError: the mask is of another size, or the box reaches out of the image.
    """
    rows, columns = shape
    if isinstance(region, Box):
        if region.right > columns or region.bottom > rows:
            raise ValueError(f"{region} reaches out of the {columns} × {rows} pixels of the image: cut it at its edge")
        return region.to_bytes()
    if region.pixels.shape != shape:
        raise ValueError(
            f"the mask is {region.pixels.shape}, the image {tuple(shape)} (rows, columns): "
            "masks of a colour image have to be aligned with the depth image first"
        )
    return region.to_png()


def points_of(pixels: np.ndarray, camera: Camera | None) -> np.ndarray:
    """Pixels with depth as points (N, 3), metres, in the camera's optical frame; of many some, evenly."""
    camera = check_camera(camera, pixels.shape)
    metres_per_unit = 1.0 if pixels.dtype == np.float32 else camera.metres_per_unit
    return thin_out(depth_images.DepthImage(pixels, metres_per_unit, camera.intrinsics).whole().points)
