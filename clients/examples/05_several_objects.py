"""Track several objects in the same clouds: one session each, every cloud is put to all of them.

    python clients/examples/05_several_objects.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

Sessions do not know of each other. Here a second mug is the first one, set half a metre to the right.
"""

import sys
from contextlib import ExitStack

import numpy as np

from captra.data.recordings import load_recording
from captra.geometry import Pose
from clients import Result, open_session

recording = load_recording(sys.argv[1])
aside = np.array([0.5, 0.0, 0.0])
init = recording.init
poses = [init, Pose.from_size(init.rotation, init.translation + aside, init.size)]

with ExitStack() as resources:
    sessions = [resources.enter_context(open_session(recording.category.name, pose)) for pose in poses]
    for cloud, stamp_ns in zip(recording.clouds, recording.stamps_ns, strict=True):
        scene = np.concatenate([cloud, cloud + aside])
        for session in sessions:
            session.put(scene, int(stamp_ns))
        for number, session in enumerate(sessions):
            answer = session.receive()
            while not isinstance(answer, Result):  # events come the same way
                answer = session.receive()
            x, y, z = answer.parts[0].translation
            print(f"object {number} at {x:.3f} {y:.3f} {z:.3f} m, {answer.state}", end="\n" if number else "   ")
