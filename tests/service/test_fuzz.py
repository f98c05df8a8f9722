"""Malformed clouds: each refused with its reason, and a neighbour never gets a wrong answer."""

from collections import Counter
from itertools import islice

import pytest

from benchmarks.malformed import malformed_clouds
from service.envelopes import Envelope, pack_attachment
from service.rejections import FRAME_REASONS, FrameRejectedError
from tests.service.support import F32, Running, blob, f32

CLOUDS = 100_000
NEIGHBOUR_EVERY = 1000


def test_malformed_clouds_crash_nothing_and_reach_no_neighbour(service: Running) -> None:
    target, neighbour = (service.service.registry.get(service.open_session()["session_id"]) for _ in range(2))
    reasons: Counter[str] = Counter()
    for number, envelope in enumerate(islice(malformed_clouds(seed=5), CLOUDS)):
        with pytest.raises(FrameRejectedError) as refused:
            target.process(envelope)
        reasons[refused.value.reason] += 1
        if number % NEIGHBOUR_EVERY == 0:
            x = 0.02 * (number // NEIGHBOUR_EVERY % 2)
            good = Envelope(F32, f32(blob((x, 0, 0.5))), pack_attachment(number, number), 0.0)
            result = neighbour.process(good)
            assert result.seq == number
            assert result.parts[0].translation == pytest.approx((x, 0, 0.5), abs=3e-3)
    assert sum(reasons.values()) == CLOUDS
    assert reasons["internal-error"] == 0
    assert set(reasons) <= set(FRAME_REASONS)
    assert len(reasons) >= 7
    assert target.last_result.confidence == 0, "at most that nothing was seen"
    assert neighbour.ledger.counts.rejected == 0
