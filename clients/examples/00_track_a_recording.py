"""Track the object of a recording, cloud by cloud, and print where it is.

Start a service first (`make serve`), then run

    python clients/examples/00_track_a_recording.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

A recording stands in for a camera here: it has the first pose, which every track needs, and clouds in metres. With your
own camera, clouds come from any iterable of (N, 3) arrays, and the first pose from a detector or from a person.
"""

import sys

from captra.data.recordings import load_recording
from clients import open_session

recording = load_recording(sys.argv[1])

with open_session(recording.category.name, recording.init) as session:
    for result in session.track(recording.clouds):  # rate_hz=30 would send them as a camera does
        for part in result.parts:
            x, y, z = part.translation
            print(f"{result.seq:3d} {result.state} {result.confidence:.2f}  {part.name} at {x:.3f} {y:.3f} {z:.3f} m")
