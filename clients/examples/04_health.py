"""Use poses only while they can be trusted, and start again when the track is lost.

    python clients/examples/04_health.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

`state` says whether to use a pose; `confidence` is the probability that it is within 5° and 5 cm. Here the camera sees
nothing for a while, as when an arm is in the way; events tell of clouds that could not be used.
"""

import sys
from collections.abc import Iterator

import numpy as np

from captra.data.recordings import Recording, load_recording
from captra.health import State
from clients import Event, open_session

BLIND = range(20, 30)


def clouds(recording: Recording) -> Iterator[np.ndarray]:
    """The recording, with frames in which only a wall is seen, two metres away."""
    wall = np.random.default_rng(0).uniform([-0.5, -0.5, 1.99], [0.5, 0.5, 2.01], (5000, 3))
    for frame, cloud in enumerate(recording.clouds):
        yield wall if frame in BLIND else cloud


def note(event: Event) -> None:
    """Print what happens to the session; the default raises an exception when a cloud is rejected."""
    print(f"event: {event.kind} {event.reason}: {event.detail or event.state}")


recording = load_recording(sys.argv[1])
restarts = 0

with open_session(recording.category.name, recording.init) as session:
    for result in session.track(clouds(recording), on_event=note):
        if result.state is State.TRACKING:
            print(f"frame {result.seq}: use it ({result.confidence:.2f})")
        elif result.state is State.LOST:
            session.reset(
                recording.truth(min(result.seq + 1, len(recording) - 1))
            )  # yours: from a detector or a person
            restarts += 1
        else:
            print(f"frame {result.seq}: wait, {result.state} ({result.confidence:.2f})")

print(f"started again {restarts} times")
