"""Track an object in the depth images of a camera.

    python clients/examples/01_depth_camera.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

Cameras give depth as 16-bit images in millimetres (some in tenths: mind the unit) and a matrix of intrinsics. Images
are sent as they are; the service reads the pixels around the object. Here `depth_images` makes such images from a
recording; put your camera's loop in its place, such as

    while True:
        frames = pipeline.wait_for_frames()           # pyrealsense2
        yield np.asanyarray(frames.get_depth_frame().get_data()), time.time_ns()

or one that reads files: `Frame(DepthPng(path.read_bytes()), stamp_ns)` sends a 16-bit PNG without unpacking it. To a
service on another machine, `DepthImage(depth).to_png()` saves bandwidth.
"""

import sys
from collections.abc import Iterator

import numpy as np

from captra.data.recordings import Recording, load_recording
from clients import Camera, DepthImage, Frame, open_session

CAMERA = Camera(fx=590, fy=590, cx=319.5, cy=239.5, width=640, height=480, metres_per_unit=0.001)


def depth_images(recording: Recording) -> Iterator[tuple[np.ndarray, int]]:
    """Depth in millimetres (height, width) as uint16, zero where there is none, and the time of capture."""
    for cloud, stamp_ns in zip(recording.clouds, recording.stamps_ns, strict=True):
        image = np.zeros((CAMERA.height, CAMERA.width), np.uint16)
        column, row = np.rint(cloud[:, :2] / cloud[:, 2:] * CAMERA.fx + [CAMERA.cx, CAMERA.cy]).astype(int).T
        seen = (column >= 0) & (column < CAMERA.width) & (row >= 0) & (row < CAMERA.height)
        image[row[seen], column[seen]] = np.rint(cloud[seen, 2] / CAMERA.metres_per_unit)
        yield image, int(stamp_ns)


recording = load_recording(sys.argv[1])
frames = (Frame(DepthImage(depth), stamp_ns) for depth, stamp_ns in depth_images(recording))
frame_id = "camera_depth_optical_frame"

with open_session(recording.category.name, recording.init, frame_id=frame_id, camera=CAMERA) as session:
    for result in session.track(frames):
        x, y, z = result.parts[0].translation
        print(f"{result.frame_id} at {result.stamp_ns} ns: {result.state}, centre {x:.3f} {y:.3f} {z:.3f} m")
