"""What is to be seen on the page, and where."""

import io
from collections.abc import Sequence
from typing import Any

import numpy as np
from PIL import Image
from playwright.sync_api import Page

from captra.geometry import box_corners, matrix_from_quat_xyzw
from tests.service.support import blob

GREEN, AMBER, RED = (62, 207, 142), (242, 184, 75), (240, 97, 109)
"""Tracking, uncertain, lost."""
BLUE = (122, 162, 247)
"""Latency."""
EDGES = [(a, b) for a in range(8) for b in range(a) if (a ^ b).bit_count() == 1]
"""Corners of a box that are next to each other, in the order of `box_corners`."""

Pixels = np.ndarray[Any, Any]


def canvas(page: Page) -> Pixels:
    """The pixels of the 3D view."""
    return pixels(page.locator("#canvas").screenshot())


def pixels(png: bytes) -> Pixels:
    """Rows, columns, RGB."""
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)


def differing(one: Pixels, other: Pixels) -> float:
    """The share of pixels that differ."""
    return float((np.abs(one - other).max(axis=2) > 0).mean())


def scene(points: int = 4000) -> np.ndarray[Any, Any]:
    """An object of 10 cm at (0, 0, 0.5) m, with something behind it."""
    wall = np.random.default_rng(2).uniform((-0.3, -0.2, 0.7), (0.3, 0.2, 0.8), (points, 3))
    return np.concatenate([blob(), wall]).astype(np.float32)


def project(page: Page, points: np.ndarray[Any, Any]) -> Pixels:
    """Where points (metres) are in the 3D view, by the camera that the page names: N x 2, CSS pixels."""
    camera = page.evaluate("captra.camera()")
    projection, world = (np.array(camera[name]).reshape(4, 4).T for name in ("projection", "world"))
    clip = np.c_[points, np.ones(len(points))] @ (projection @ world).T
    height, width = canvas(page).shape[:2]
    found: Pixels = (clip[:, :2] / clip[:, 3:] * (0.5, -0.5) + 0.5) * (width, height)
    return found


def eye(page: Page) -> np.ndarray[Any, Any]:
    """Where the page looks from, metres."""
    found: np.ndarray[Any, Any] = np.linalg.inv(np.array(page.evaluate("captra.camera()")["world"]).reshape(4, 4).T)[
        :3, 3
    ]
    return found


def corners_of(part: dict[str, Any]) -> np.ndarray[Any, Any]:
    """Corners of the box of a part as the service reports it, metres: 8 x 3."""
    rotation = matrix_from_quat_xyzw(np.array(part["quat_xyzw"]))
    found: np.ndarray[Any, Any] = box_corners(np.array(part["size"])) @ rotation.T + part["translation"]
    return found


def assert_boxes_drawn(page: Page, parts: Sequence[dict[str, Any]], colour: tuple[int, int, int]) -> None:
    """Every edge of every part's box runs in `colour` where the camera sees it."""
    drawn = canvas(page)
    for part in parts:
        expected = project(page, corners_of(part))
        for a, b in EDGES:
            for share in (0.3, 0.5, 0.7):
                u, v = np.rint(expected[a] + share * (expected[b] - expected[a])).astype(int)
                around = drawn[v - 2 : v + 3, u - 2 : u + 3].reshape(-1, 3)
                hue = around - around.mean(axis=1, keepdims=True)
                wanted = np.array(colour) - np.mean(colour)
                likeness = (hue @ wanted) / (np.linalg.norm(hue, axis=1) * np.linalg.norm(wanted) + 1e-9)
                vivid = np.linalg.norm(hue, axis=1) > 12
                assert (likeness[vivid] > 0.9).any(), f"no edge of a box in {colour} at ({u}, {v}), where one should be"
