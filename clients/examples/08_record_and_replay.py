"""Record a session into an MCAP file, which Foxglove and Rerun open, and replay it: the poses are the same.

Start a service first (`make serve`), then run

    python clients/examples/08_record_and_replay.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from captra.data.recordings import load_recording
from clients import open_session
from clients.replay import replay

recording = load_recording(sys.argv[1])

with TemporaryDirectory() as folder:
    path = Path(folder) / "session.mcap"
    with open_session(recording.category.name, recording.init, record=path) as session:
        for _ in session.track(recording.clouds):
            pass
    for pair in replay(None, path, lambda _: None):
        words = "the same" if pair.identical else "another pose"
        print(f"{pair.recorded.seq:3d} {pair.recorded.state} {words}")
