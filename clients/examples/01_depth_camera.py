"""Track an object in the depth images of a camera.

    python clients/examples/01_depth_camera.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

Cameras give depth as 16-bit images in millimetres (some in tenths: mind the unit) and a matrix of intrinsics. Here
`depth_images` makes such images from a recording; put your camera's loop in its place, such as

    while True:
        frames = pipeline.wait_for_frames()           # pyrealsense2
        yield np.asanyarray(frames.get_depth_frame().get_data()), time.time_ns()
"""

import sys
from collections.abc import Iterator

import numpy as np

from captra.data.recordings import Recording, load_recording
from clients import Frame, crop_ball, open_session, thin_out

FOCAL_PX, WIDTH, HEIGHT = 590.0, 640, 480
MILLIMETRE = 0.001


def depth_images(recording: Recording) -> Iterator[tuple[np.ndarray, int]]:
    """Depth in millimetres (HEIGHT, WIDTH), zero where there is none, and the time of capture."""
    for cloud, stamp_ns in zip(recording.clouds, recording.stamps_ns, strict=True):
        image = np.zeros((HEIGHT, WIDTH), np.uint16)
        column, row = np.rint(cloud[:, :2] / cloud[:, 2:] * FOCAL_PX + [WIDTH / 2, HEIGHT / 2]).astype(int).T
        seen = (column >= 0) & (column < WIDTH) & (row >= 0) & (row < HEIGHT)
        image[row[seen], column[seen]] = np.rint(cloud[seen, 2] / MILLIMETRE)
        yield image, int(stamp_ns)


def points(depth_mm: np.ndarray) -> np.ndarray:
    """The points of all pixels that have a depth, metres, in the camera's optical frame: x right, y down, z forward."""
    row, column = np.nonzero(depth_mm)
    z = depth_mm[row, column] * MILLIMETRE
    return np.stack([(column - WIDTH / 2) / FOCAL_PX * z, (row - HEIGHT / 2) / FOCAL_PX * z, z], axis=1)


def clouds(recording: Recording, radius_m: float, centre: np.ndarray) -> Iterator[Frame]:
    """What goes to the service: the surroundings of the object are enough, and fit into one message."""
    for image, stamp_ns in depth_images(recording):
        yield Frame(thin_out(crop_ball(points(image), centre, radius_m)), stamp_ns)


recording = load_recording(sys.argv[1])
centre, reach_m = recording.init.translation[0], 3 * recording.init.scale[0]

with open_session(recording.category.name, recording.init, frame_id="camera_depth_optical_frame") as session:
    for result in session.track(clouds(recording, reach_m, centre)):
        x, y, z = result.parts[0].translation
        print(f"{result.frame_id} at {result.stamp_ns} ns: {result.state}, centre {x:.3f} {y:.3f} {z:.3f} m")
        centre = np.array(result.parts[0].translation)
