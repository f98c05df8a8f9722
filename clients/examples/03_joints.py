"""Follow every part of an object with joints, and how far they are open.

    python clients/examples/03_joints.py recordings/scissors__sweethome3d-BlendSwap-CC-0__cissors_swap__hand.npz

Articulated objects have a pose for each part, given and answered in the order of `GET /v1/categories`, and a value for
each joint: radians for hinges, metres for slides, zero at rest. Their clouds hold the object alone, or bring
masks (09_masks.py).
"""

import sys

from captra.data.recordings import load_recording
from clients import open_session

recording = load_recording(sys.argv[1])
print("parts:", ", ".join(recording.category.parts))

with open_session(recording.category.name, recording.init) as session:
    for result in session.track(recording.clouds):
        joints = "  ".join(f"{joint.name} {joint.value:+.3f}" for joint in result.joints)
        print(f"frame {result.seq}: {result.state}  {joints}")
