"""A track that was lost, searched for and found replays to the last digit, however fast the machine is then."""

from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pytest

from captra.categories import CATEGORIES
from captra.geometry import Pose
from clients.packing import Frame
from clients.replay import replay
from clients.session import open_session
from tests.service.support import CentreProvider, Running, blob, running
from tests.service.test_lost_and_found import DepthOnly, board, nothing

START = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0.0, 0.5]]), np.full((1, 3), 0.1))
HURRIED_MS, PATIENT_MS = 1e-3, 10_000.0
FRAME_NS = 33_000_000


@pytest.fixture(scope="module")
def hurried_and_patient() -> Iterator[Sequence[Running]]:
    """Two services: one has time for the fewest looks, the other for the most."""
    with ExitStack() as resources:
        services = []
        for budget_ms in (HURRIED_MS, PATIENT_MS):
            provider = CentreProvider()
            provider.networks["mug"] = DepthOnly(CATEGORIES["mug"])
            services.append(resources.enter_context(running(provider=provider, search_budget_ms=budget_ms)))
        for service in services:
            assert service.service.readiness.wait_prepared(60)
        yield services


def hidden_twice() -> list[Frame]:
    """Seen, behind a board, seen elsewhere, gone for a while, seen elsewhere again; it trembles all the while."""
    hidden = [board()] * 8
    gone = [nothing()] * 6
    rng = np.random.default_rng(5)
    clouds = [
        *(blob(rng.normal((0, 0, 0.5), 2e-3).tolist()) for _ in range(3)),
        *hidden,
        *(blob(rng.normal((0.07, 0, 0.5), 2e-3).tolist()) for _ in range(14)),
        *gone,
        *(blob(rng.normal((0.07, 0.05, 0.5), 2e-3).tolist()) for _ in range(14)),
    ]
    return [Frame(cloud, FRAME_NS * index) for index, cloud in enumerate(clouds)]


@pytest.mark.parametrize("recorder", [0, 1], ids=["recorded in a hurry", "recorded with patience"])
def test_a_track_that_was_lost_and_found_replays_to_the_last_digit(
    hurried_and_patient: Sequence[Running], recorder: int, tmp_path: Path
) -> None:
    then, now = (str(hurried_and_patient[index].http.base_url) for index in (recorder, 1 - recorder))
    path, frames = tmp_path / "search.mcap", hidden_twice()
    with open_session("mug", START, url=then, record=path) as session:
        results = list(session.track(frames, on_event=lambda event: None))
    states = [result.state for result in results]
    assert list(dict.fromkeys(states)) == ["tracking", "uncertain", "lost", "recovering"]
    assert states[-1] == "tracking"
    assert {result.looks for result in results[4:]} == ({2} if recorder == 0 else {8})
    pairs = replay(now, path, lambda _: None)
    assert len(pairs) >= len(frames) - 6
    assert [pair.recorded.seq for pair in pairs if not pair.identical] == []
