"""Say with each frame which pixels are the object's: a mask from a detector, or a bounding box.

    python clients/examples/09_masks.py recordings/scissors__sweethome3d-BlendSwap-CC-0__cissors_swap__hand.npz

A mask takes the place of the network's own segmentation. Articulated objects need one wherever anything else is in
view, as the table is here. `views` makes depth images and masks from a recording; put your camera and detector in its
place:

    depth, colour = camera.read()                       # colour aligned with depth, pixel by pixel
    yield depth, detector(colour) > 0.5, time.time_ns()

For a rigid object a box often does: `Frame(DepthImage(depth), stamp_ns, Box(left, top, right, bottom))`. Clouds may
have masks too: one value for each point.
"""

import sys
from collections.abc import Iterator

import numpy as np

from captra.data.recordings import Recording, load_recording
from clients import Camera, DepthImage, Frame, Mask, open_session

CAMERA = Camera(fx=590, fy=590, cx=319.5, cy=239.5, width=640, height=480, metres_per_unit=0.001)
BEHIND_M = 0.05


def views(recording: Recording) -> Iterator[tuple[np.ndarray, np.ndarray, int]]:
    """Depth of the object before a table (mm, uint16), where the object is (bool), and the time of capture."""
    for cloud, stamp_ns in zip(recording.clouds, recording.stamps_ns, strict=True):
        table_mm = 1000 * (cloud[:, 2].max() + BEHIND_M)
        depth = np.full((CAMERA.height, CAMERA.width), table_mm, np.uint16)
        column, row = np.rint(cloud[:, :2] / cloud[:, 2:] * CAMERA.fx + [CAMERA.cx, CAMERA.cy]).astype(int).T
        seen = (column >= 0) & (column < CAMERA.width) & (row >= 0) & (row < CAMERA.height)
        depth[row[seen], column[seen]] = np.rint(cloud[seen, 2] / CAMERA.metres_per_unit)
        yield depth, depth < table_mm - 1, int(stamp_ns)


recording = load_recording(sys.argv[1])
frames = (Frame(DepthImage(depth), stamp_ns, Mask(mask)) for depth, mask, stamp_ns in views(recording))

with open_session(recording.category.name, recording.init, camera=CAMERA, masks="object") as session:
    for result in session.track(frames):
        middles = "  ".join(f"{part.name} at {part.translation[2]:.3f} m" for part in result.parts)
        print(f"frame {result.seq}: {result.state} {result.confidence:.2f}  {middles}")
