"""Clouds as a ROS 2 driver publishes them, serialized by rosbags."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from service.ros2.messages import POINT_CLOUD2, type_store

DATATYPES = {"i1": 1, "u1": 2, "i2": 3, "u2": 4, "i4": 5, "u4": 6, "f4": 7, "f8": 8}
XYZ = (("x", "f4"), ("y", "f4"), ("z", "f4"))
STAMP_NS = 1_700_000_000_000_000_123


def cdr(
    points: np.ndarray,
    fields: Sequence[tuple[str, str]] = XYZ,
    *,
    pad: int = 0,
    row_pad: int = 0,
    big_endian_data: bool = False,
    big_endian_cdr: bool = False,
    frame_id: str = "camera_depth_optical_frame",
    cut: int = 0,
) -> bytes:
    """Points (N, 3) or (rows, columns, 3), m, with `fields` in the given order.

    Every field is followed by `pad` bytes, every row by `row_pad`; the last `cut` bytes of data are missing.
    """
    message = cloud_message(points, fields, pad, row_pad, big_endian_data, frame_id, cut)
    return bytes(type_store().serialize_cdr(message, POINT_CLOUD2, little_endian=not big_endian_cdr))


def cloud_message(
    points: np.ndarray,
    fields: Sequence[tuple[str, str]],
    pad: int,
    row_pad: int,
    big_endian: bool,
    frame_id: str,
    cut: int,
) -> Any:
    grid: np.ndarray[Any, Any] = points if points.ndim == 3 else points[None]
    order = ">" if big_endian else "<"
    offsets, step = [], 0
    for _, kind in fields:
        offsets.append(step)
        step += np.dtype(kind).itemsize + pad
    names = [name for name, _ in fields]
    layout = np.dtype(
        {"names": names, "formats": [order + kind for _, kind in fields], "offsets": offsets, "itemsize": max(step, 1)}
    )
    rows: np.ndarray[Any, Any] = np.zeros((grid.shape[0], grid.shape[1]), layout)
    for name in names:
        rows[name] = grid[..., "xyz".index(name)] if name in "xyz" else 7
    height, columns = grid.shape[0], grid.shape[1]
    width = columns * layout.itemsize
    padded = np.full((height, width + row_pad), 0xAB, np.uint8)
    if rows.size:
        padded[:, :width] = np.frombuffer(rows.tobytes(), np.uint8).reshape(height, width)
    types = type_store().types
    stamp = types["builtin_interfaces/msg/Time"](sec=STAMP_NS // 10**9, nanosec=STAMP_NS % 10**9)
    field = types["sensor_msgs/msg/PointField"]
    data = padded.reshape(-1)
    return types[POINT_CLOUD2](
        header=types["std_msgs/msg/Header"](stamp=stamp, frame_id=frame_id),
        height=height,
        width=columns,
        fields=[
            field(name=name, offset=offset, datatype=DATATYPES[kind], count=1)
            for (name, kind), offset in zip(fields, offsets, strict=True)
        ],
        is_bigendian=big_endian,
        point_step=layout.itemsize,
        row_step=width + row_pad,
        data=data[: len(data) - cut],
        is_dense=bool(np.isfinite(grid).all()),
    )
