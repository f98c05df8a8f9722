import numpy as np
import pytest

from captra.bench.machine import this_machine
from captra.bench.streams import Percentiles, run_streams
from captra.bench.table import table
from tests.captra.evaluation.test_evaluation import still_recording
from tests.oracle import OracleNetworks


def test_every_frame_of_every_stream_is_timed() -> None:
    recording = still_recording("can")
    truth = recording.truth(0)
    run = run_streams(OracleNetworks(recording.category, truth, truth), recording, "none", streams=2, frames=6)
    assert (run.frames, run.streams, run.category, run.profile) == (12, 2, "can", "realtime")
    assert run.fps > 0
    assert 0 < run.total.p50 <= run.total.p95 <= run.total.p99
    assert run.total.p50 >= run.sample.p50
    assert 0 < run.slowest_stream_share <= 1
    assert table([run], 12.66).row_count == 1


def test_percentiles_of_a_ramp() -> None:
    found = Percentiles.of(list(np.arange(101.0)))
    assert (found.p50, found.p95, found.p99) == (50, 95, 99)
    with pytest.raises(ValueError, match="nothing"):
        Percentiles.of([])


def test_the_machine_is_named() -> None:
    machine = this_machine()
    assert machine.cores >= 1
    assert machine.cpu
    assert "numpy" in machine.packages
