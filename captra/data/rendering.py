"""Pinhole depth by ray casting, within the image region of a ball."""

from dataclasses import dataclass

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from jaxtyping import Float, Float32, Float64, Int16

from captra.data.shapes.mesh import Mesh

NOTHING = -1
"""Body index of pixels whose ray hits nothing."""


@dataclass(frozen=True)
class Camera:
    """A pinhole camera, x right, y down, z forward."""

    focal_px: float
    """Focal length of both axes."""
    width: int = 640
    """Pixels."""
    height: int = 480
    """Pixels."""

    @property
    def center_px(self) -> tuple[float, float]:
        """Principal point: the middle of the image."""
        return (self.width - 1) / 2, (self.height - 1) / 2


@dataclass(frozen=True)
class DepthPatch:
    """A rectangle of a depth image, every `stride`-th pixel of it."""

    camera: Camera
    """What took it."""
    origin_px: tuple[int, int]
    """Column and row of the first pixel."""
    stride: int
    """Distance of neighbours in image pixels."""
    depth: Float32[np.ndarray, "H W"]
    """z in metres; 0 where there is none."""
    body: Int16[np.ndarray, "H W"]
    """Index of the mesh that the ray hit, or NOTHING."""
    cosine: Float32[np.ndarray, "H W"]
    """|cos| of the angle between the ray and the surface normal; 0 where nothing was hit."""

    def directions(self) -> Float32[np.ndarray, "H W 3"]:
        """Rays through the pixels with z = 1, so that depth times direction is the point."""
        height, width = self.depth.shape
        return pixel_rays(self.camera, self.origin_px, (height, width), self.stride)


def pixel_rays(
    camera: Camera, origin_px: tuple[int, int], shape: tuple[int, int], stride: int
) -> Float32[np.ndarray, "H W 3"]:
    """Directions with z = 1 through a grid of pixels."""
    cx, cy = camera.center_px
    x = (origin_px[0] + np.arange(shape[1]) * stride - cx) / camera.focal_px
    y = (origin_px[1] + np.arange(shape[0]) * stride - cy) / camera.focal_px
    grid = np.empty((*shape, 3), np.float32)
    grid[..., 0], grid[..., 1], grid[..., 2] = x, y[:, None], 1
    return grid


def ball_region(camera: Camera, center: Float[np.ndarray, " 3"], radius: float) -> tuple[int, int, int, int]:
    """Columns and rows [left, right) × [top, bottom) of the image that may see a ball; empty if it is out of sight."""
    cx, cy = camera.center_px
    near = max(float(center[2]) - radius, 0.05)
    bounds = []
    for middle, offset, limit in ((center[0], cx, camera.width), (center[1], cy, camera.height)):
        edges = [camera.focal_px * (middle + sign * radius) / z for sign in (-1, 1) for z in (near, float(center[2]))]
        bounds.append((int(np.clip(min(edges) + offset, 0, limit)), int(np.clip(max(edges) + offset + 1, 0, limit))))
    (left, right), (top, bottom) = bounds
    return left, right, top, bottom


def cast(
    bodies: list[Mesh], camera: Camera, center: Float[np.ndarray, " 3"], radius: float, max_rays: int
) -> DepthPatch:
    """Depth of meshes in the camera frame, around a ball; the stride grows until at most `max_rays` are cast."""
    left, right, top, bottom = ball_region(camera, center, radius)
    area = max(right - left, 1) * max(bottom - top, 1)
    stride = max(1, int(np.ceil(np.sqrt(area / max_rays))))
    shape = (max(1, -(-(bottom - top) // stride)), max(1, -(-(right - left) // stride)))
    rays = pixel_rays(camera, (left, top), shape, stride)
    flat = rays.reshape(-1, 3)
    scene = EmbreeScene()
    starts = np.cumsum([0, *(len(body.vertices) for body in bodies)])
    vertices = np.concatenate([body.vertices for body in bodies]).astype(np.float32)
    faces = np.concatenate([body.faces + start for body, start in zip(bodies, starts[:-1], strict=True)])
    owner = np.repeat(np.arange(len(bodies)), [len(body.faces) for body in bodies]).astype(np.int16)
    TriangleMesh(scene, vertices, faces.astype(np.int32))
    hit = scene.run(np.zeros_like(flat), flat, query="INTERSECT", output=True)
    seen = hit["primID"] >= 0
    depth = np.where(seen, hit["tfar"], 0).astype(np.float32)
    body = np.where(seen, owner[np.maximum(hit["primID"], 0)], NOTHING).astype(np.int16)
    cosine = _cosine(hit["Ng"], flat) * seen
    return DepthPatch(
        camera, (left, top), stride, depth.reshape(shape), body.reshape(shape), cosine.reshape(shape).astype(np.float32)
    )


def _cosine(normal: Float32[np.ndarray, "N 3"], rays: Float32[np.ndarray, "N 3"]) -> Float64[np.ndarray, " N"]:
    length = np.sqrt(np.einsum("ij,ij->i", normal, normal) * np.einsum("ij,ij->i", rays, rays))
    return np.asarray(np.abs(np.einsum("ij,ij->i", normal, rays)) / np.maximum(length, 1e-20))
