"""Everyone who observes a session hears the same, in order, until they stop."""

import numpy as np

from captra.observations import Observation
from service.envelopes import NumberedHeader
from service.results import Event, Result
from tests.service.support import Running, blob, f32


class Diary:
    def __init__(self) -> None:
        self.heard: list[str] = []
        self.seen: list[Observation] = []

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        self.heard.append(f"cloud {header.seq}")
        self.seen.append(observation)

    def result(self, result: Result) -> None:
        self.heard.append(f"result {result.seq}")

    def event(self, event: Event) -> None:
        self.heard.append(f"{event.kind} {event.reason}")


def test_observers_hear_clouds_results_and_rejections_in_order(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    first, second = Diary(), Diary()
    session = service.service.registry.get(session_id)
    for diary in (first, second):
        session.observe(diary)
    service.post_frame(session_id, f32(blob()), seq=1)
    service.post_frame(session_id, f32(blob((0, 0, 5))), seq=2)
    session.unobserve(first)
    service.post_frame(session_id, f32(blob()), seq=3)
    assert first.heard == ["cloud 1", "result 1", "cloud 2", "rejected no-points-near-object"]
    assert second.heard == [*first.heard, "cloud 3", "result 3"]
    np.testing.assert_array_equal(first.seen[0].whole().points, blob())
