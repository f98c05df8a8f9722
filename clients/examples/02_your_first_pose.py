"""Make the first pose of an object that stands on a table, from what a person or a detector can tell.

    python clients/examples/02_your_first_pose.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

Needed are the middle of the object's box, its size, and two directions, all in the frame of the clouds: where its y
axis points (up, for objects of the rigid categories) and where its x axis points (to a mug's handle, out of a camera's
lens, to the open side of a laptop; for bottles, cans and bowls anywhere). As close as 5° and 3 cm is good.
"""

import sys

import numpy as np

from captra.data.recordings import load_recording
from captra.geometry import Pose
from clients import open_session


def first_pose(centre: np.ndarray, size: np.ndarray, y_axis: np.ndarray, x_axis: np.ndarray) -> Pose:
    """A pose of one part from the directions of two of its axes, of any length; x is made perpendicular to y."""
    y = y_axis / np.linalg.norm(y_axis)
    z = np.cross(x_axis, y)
    z /= np.linalg.norm(z)
    rotation = np.stack([np.cross(y, z), y, z], axis=1)  # the columns are the object's axes
    return Pose.from_size(rotation[None], centre[None], size[None])


recording = load_recording(sys.argv[1])
truth = recording.truth(0)
x_axis, y_axis, _ = truth.rotation[0].T  # in place of what you see: "the handle points left, the mug stands upright"
pose = first_pose(
    centre=truth.translation[0] + [0.01, 0.01, 0.0],  # a centimetre off
    size=np.round(truth.size[0], 2),  # as measured with a ruler
    y_axis=y_axis + [0.05, 0, 0],  # some degrees off
    x_axis=x_axis + [0, 0.05, 0],
)

with open_session(recording.category.name, pose) as session:
    for frame, result in enumerate(session.track(recording.clouds)):
        off_cm = 100 * np.linalg.norm(result.pose.translation - recording.truth(frame).translation)
        print(f"frame {frame}: {result.state}, {off_cm:.1f} cm from the truth")
