"""What is refused before it is sent, with what to do instead, and what goes over the wire."""

import io
from collections.abc import Callable

import numpy as np
import pytest
from PIL import Image

from clients import Box, Camera, DepthImage, DepthPng, Mask, PointCloud2
from clients.clouds import get_encoding
from clients.packing import Packer
from clients.regions import PACKED_BOX

CAMERA = Camera(fx=60, fy=60, cx=31.5, cy=23.5, width=64, height=48)
DEPTH = np.full((48, 64), 500, np.uint16)
POINTS = np.array([[0, 0, 0.5], [np.nan, 0, 0], [0, 0, 5.0], [0.1, 0, 0.5]], np.float32)


def packer(camera: Camera | None = CAMERA, masks: str | None = "object", encoding: str = "i16") -> Packer:
    return Packer(get_encoding(encoding), camera, masks)


def pixels_of(png: bytes) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(png)))


def test_depth_goes_as_it_is_or_compressed() -> None:
    raw, png = packer().pack(DepthImage(DEPTH), None), packer().pack(DepthImage(DEPTH).to_png(), None)
    assert raw.media_type == "application/vnd.captra.depth.u16"
    assert raw.payload == DEPTH.tobytes()
    assert png.media_type == "image/png"
    assert np.array_equal(pixels_of(png.payload), DEPTH)
    assert len(png.payload) < len(raw.payload) / 2
    metres = packer().pack(DepthImage(np.float32(1e-3) * DEPTH), None)
    assert metres.media_type == "application/vnd.captra.depth.f32"


def test_every_other_pixel_of_a_larger_image_is_sent_in_order() -> None:
    large = np.arange(96 * 128, dtype=np.uint16).reshape(96, 128)
    assert packer().pack(DepthImage(large[::2, ::2]), None).payload == large[::2, ::2].copy().tobytes()
    assert np.array_equal(pixels_of(DepthImage(large[::2, ::2]).to_png().data), large[::2, ::2])


def test_viewers_are_shown_points_in_the_optical_frame() -> None:
    one = np.zeros_like(DEPTH)
    one[23, 61] = 500
    for image in (DepthImage(one), DepthImage(one).to_png(), DepthImage(np.float32(1e-3) * one)):
        (point,) = packer().pack(image, None).shown()
        assert point == pytest.approx([0.5 * (61 - 31.5) / 60, 0.5 * (23 - 23.5) / 60, 0.5])


def test_a_mask_loses_the_points_that_the_cloud_loses() -> None:
    mask = Mask(np.array([1, 2, 3, 4], np.uint8))
    near, finite = packer().pack(POINTS, mask), packer(encoding="f32").pack(POINTS, mask)
    assert pixels_of(near.region).tolist() == [[1, 4]]
    assert len(near.payload) == 2 * 6
    assert pixels_of(finite.region).tolist() == [[1, 3, 4]]
    assert len(finite.payload) == 3 * 12
    organized = packer().pack(POINTS.reshape(2, 2, 3), Mask(np.array([[True, True], [True, False]])))
    assert pixels_of(organized.region).tolist() == [[1, 0]]


def test_boxes_of_detectors_are_rounded_outwards_and_cut_off() -> None:
    assert Box.around(-3.2, 1.5, 9.1, 70.0, columns=64, rows=48) == Box(0, 1, 10, 48)
    with pytest.raises(ValueError, match="no pixel"):
        Box.around(70.0, 1.0, 90.0, 20.0, columns=64, rows=48)


def test_boxes_are_four_numbers() -> None:
    assert packer().pack(DepthImage(DEPTH), Box(3, 2, 64, 48)).region == PACKED_BOX.pack(3, 2, 64, 48)
    assert packer().pack(PointCloud2(b"message"), Box(0, 0, 1, 1)).region == PACKED_BOX.pack(0, 0, 1, 1)


def test_a_matrix_of_intrinsics_makes_a_camera() -> None:
    assert Camera.from_matrix(np.array([[60, 0, 31.5], [0, 60, 23.5], [0, 0, 1]]), 64, 48) == CAMERA


REFUSED: dict[str, tuple[Callable[[], object], str]] = {
    "no camera": (lambda: packer(camera=None).pack(DepthImage(DEPTH), None), r"camera=Camera\(fx, fy, cx, cy"),
    "another size": (lambda: packer().pack(DepthImage(DEPTH[:, :32]), None), "32 × 48 pixels, the camera 64 × 48"),
    "png of another size": (lambda: packer().pack(DepthImage(DEPTH[:24]).to_png(), None), "64 × 24 pixels"),
    "float64": (lambda: DepthImage(DEPTH * 1e-3), "not float64.*astype"),
    "colour": (lambda: DepthImage(np.zeros((48, 64, 3), np.uint16)), r"not uint16 \(48, 64, 3\)"),
    "metres as png": (lambda: DepthImage(np.ones((2, 2), np.float32)).to_png(), "turn metres into units"),
    "no png": (lambda: DepthPng(b"\xff\xd8JPEG"), "no PNG image"),
    "depth as a cloud": (lambda: packer().pack(DEPTH, None), r"goes as DepthImage\(pixels\)"),
    "colours": (lambda: packer().pack(np.zeros((9, 6)), None), "leave out colours"),
    "transposed": (lambda: packer().pack(np.zeros((3, 900)), None), r"points\.T"),
    "millimetres": (lambda: packer().pack(np.full((9, 3), 500.0), None), "are they millimetres"),
    "transposed matrix": (
        lambda: Camera.from_matrix(np.array([[60, 0, 0], [0, 60, 0], [31.5, 23.5, 1]]), 64, 48),
        "is it transposed",
    ),
    "masks not asked for": (
        lambda: packer(masks=None).pack(DepthImage(DEPTH), Box(0, 0, 1, 1)),
        "open it with masks='object'",
    ),
    "mask of another size": (
        lambda: packer().pack(DepthImage(DEPTH), Mask(np.ones((480, 640), np.bool_))),
        "aligned with the depth image",
    ),
    "mask of probabilities": (lambda: Mask(np.ones((48, 64))), "mask > 0"),
    "mask of other points": (lambda: packer().pack(POINTS, Mask(np.ones(3, np.bool_))), "one value for each point"),
    "box of a list": (lambda: packer().pack(POINTS, Box(0, 0, 1, 1)), "counts pixels"),
    "box beyond": (lambda: packer().pack(DepthImage(DEPTH), Box(0, 0, 65, 48)), "cut it at its edge"),
    "box between pixels": (lambda: Box(3.5, 2, 64, 48), "Box.around"),  # type: ignore[arg-type]
    "width for right": (lambda: Box(30, 20, 10, 10), "not width and height"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_sent_says_what_to_do(case: str) -> None:
    attempt, hint = REFUSED[case]
    with pytest.raises(ValueError, match=hint):
        attempt()
