"""Save every pose as a line of a CSV file.

    python clients/examples/07_poses_to_csv.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz poses.csv

One line a part: stamp, state, confidence, centre (m), quaternion x y z w, size (m).
"""

import csv
import sys
from pathlib import Path

from captra.data.recordings import load_recording
from clients import Frame, open_session

recording = load_recording(sys.argv[1])
frames = (Frame(cloud, int(stamp)) for cloud, stamp in zip(recording.clouds, recording.stamps_ns, strict=True))
pose = ("x", "y", "z", "qx", "qy", "qz", "qw", "size_x", "size_y", "size_z")
heading = ("stamp_ns", "seq", "state", "confidence", "part", *pose)

with Path(sys.argv[2]).open("w", newline="") as file, open_session(recording.category.name, recording.init) as session:
    lines = csv.writer(file)
    lines.writerow(heading)
    for result in session.track(frames):
        for part in result.parts:
            numbers = (*part.translation, *part.quat_xyzw, *part.size)
            lines.writerow([result.stamp_ns, result.seq, result.state, result.confidence, part.name, *numbers])

print(f"{len(recording)} frames of {recording.name} are in {sys.argv[2]}")
