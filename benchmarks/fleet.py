"""Many sessions of one recording at once, each moved by a distance of its own, so that an answer tells whose it is."""

import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from captra.data.recordings import Recording, load_recording
from clients import Session, SessionClosedError, open_session, thin_out
from clients.demo import COFFEE_MUG
from clients.service_process import ServiceProcess

APART_M = 0.15
"""Between neighbours of a grid: less than the object, so that a session could take another one's cloud for its own."""
WRONG_M = 0.05
"""An answer so far from the truth is wrong, whether it is another session's or none at all."""
ANSWER_WITHIN_S = 10.0
"""A cloud that has no answer by then is put again."""
FRAMES = 60
CLOUD_POINTS = 4000
MODELS = Path(__file__).resolve().parents[1] / "models"


@dataclass
class Tracked:
    """One session with its ground truth."""

    session: Session
    """Of the Python client."""
    clouds: Sequence[np.ndarray]
    """What it sees, frame by frame, metres."""
    centres: np.ndarray
    """Where the object is in each frame, metres."""
    errors_m: list[float] = field(default_factory=list)
    """Distance of each answer from the truth."""
    unanswered: int = 0
    """Clouds that were put again, since no answer came."""
    frame: int = 0
    """Which cloud is next: there and back again, so that the object never jumps."""
    ended: bool = False
    """Whether the service has closed the session, though its client lives."""
    first_seq: int | None = None
    """Number of this frame's cloud when it was first put."""
    seq: int = -1
    """Number of the last cloud that was put."""

    @property
    def _index(self) -> int:
        index = self.frame % (2 * len(self.clouds))
        return min(index, 2 * len(self.clouds) - 1 - index)

    def put(self) -> None:
        """Send the next cloud, or the same one again where the last was not answered."""
        try:
            self.seq = self.session.put(self.clouds[self._index])
        except SessionClosedError:
            self.ended = True
        if self.first_seq is None:
            self.first_seq = self.seq

    def is_answered(self) -> bool:
        """Whether a result of this frame's cloud is there, of whichever time it was put."""
        return self.session.latest is not None and self.session.latest.seq >= (self.first_seq or 0)

    def check(self) -> None:
        """Compare the answer with the truth, and go on to the next cloud."""
        if not self.is_answered():
            self.unanswered += 1
            return
        centre = np.array(self.session.latest.parts[0].translation)
        self.errors_m.append(float(np.linalg.norm(centre - self.centres[self._index])))
        self.frame, self.first_seq = self.frame + 1, None


def play_round(fleet: Sequence[Tracked], answer_within_s: float) -> None:
    """One cloud for every session at once; then all answers are compared."""
    for each in fleet:
        each.put()
    deadline = time.monotonic() + answer_within_s
    while not all(each.is_answered() for each in fleet) and time.monotonic() < deadline:
        time.sleep(0.005)
    for each in fleet:
        each.check()


@contextmanager
def mug_service(max_sessions: int, **settings: str) -> Iterator[ServiceProcess]:
    """A service with the mug's bundle alone, which keeps its sessions when it is killed and started again."""
    with TemporaryDirectory(prefix="captra-fleet-") as folder:
        state, models = Path(folder, "state"), Path(folder, "models")
        models.mkdir()
        (models / "mug").symlink_to(MODELS / "mug")
        settings |= {
            "CAPTRA_STATE_DIR": str(state),
            "CAPTRA_MODELS_DIR": str(models),
            "CAPTRA_MAX_SESSIONS": str(max_sessions),
        }
        with ServiceProcess(settings) as service:
            yield service


@contextmanager
def open_fleet(url: str, sessions: int) -> Iterator[list[Tracked]]:
    """Sessions on a grid, all of the same mug."""
    recording = load_recording(COFFEE_MUG)
    clouds = [thin_out(cloud, CLOUD_POINTS) for cloud in recording.clouds[:FRAMES]]
    side = int(np.ceil(np.cbrt(sessions)))
    with ExitStack() as resources:
        fleet = []
        for number in range(sessions):
            cell = np.array(np.unravel_index(number, (side, side, side))) - (side - 1) / 2
            fleet.append(resources.enter_context(tracked(url, recording, clouds, APART_M * cell)))
        yield fleet


@contextmanager
def tracked(url: str, recording: Recording, clouds: Sequence[np.ndarray], moved: np.ndarray) -> Iterator[Tracked]:
    """A session of a recording that is moved as a whole, metres."""
    moved = moved.astype(np.float32)
    pose = replace(recording.init, translation=recording.init.translation + moved)
    with open_session("mug", pose, url=url, idle_timeout_s=3600) as session:
        centres = recording.translation[: len(clouds), 0] + moved
        yield Tracked(session, [cloud + moved for cloud in clouds], centres)
