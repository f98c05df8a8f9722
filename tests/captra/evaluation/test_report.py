from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from rich.console import Console

from captra.evaluation.comparison import compare, over_categories
from captra.evaluation.followers import BASELINES, ROBUSTNESS
from captra.evaluation.followers.follower import Track
from captra.evaluation.moments import APART, worst_moments
from captra.evaluation.report import Report
from captra.evaluation.runner import Outcome
from captra.evaluation.scoring import score
from captra.evaluation.sequences import Sequence
from captra.evaluation.state_bands import stretches
from captra.evaluation.workers import Here
from captra.health import State
from tests.captra.evaluation.test_evaluation import Held, Ready, moved, still_recording
from tests.oracle import OracleNetworks


def test_a_report_tells_the_same_in_every_form(tmp_path: Path) -> None:
    recording = still_recording("camera", frames=3)
    truth = recording.truth(0)
    model = (np.random.default_rng(0).uniform(-0.5, 0.5, (200, 3)).astype(np.float32) * recording.size[0],)
    networks = Ready(OracleNetworks(recording.category, truth, truth))
    report, console = Report(), Console(record=True, width=200)
    sources = [Held(Sequence(recording, model))]
    others = (*ROBUSTNESS[:1], *BASELINES)
    report.measure(networks, "camera", "recordings", sources, others, Here(), console, with_response=True)
    report.measure(networks, "camera", "meshes", [], others, Here(), console, with_response=True)
    for table in report.tables("realtime"):
        console.print(table)
    told, written, plain = console.export_text(), report.markdown(), report.as_json()
    for text in ("Init x1", "oracle ICP", "C-CoordinateNet + RANSAC", "scale fixed", "mean of 1 recordings", "0.4"):
        assert text in told
        assert text in written
    assert list(report.means("camera")) == ["recordings"]
    assert {key: len(rows) for key, rows in plain.items() if isinstance(rows, list)} == {
        "sequences": 2,
        "paper": 2,
        "others": 5,
        "response": 3,
    }
    report.draw(tmp_path)
    pictures = sorted(tmp_path.iterdir())
    assert [path.name.split("_")[0] for path in pictures] == ["time", "worst"]
    assert all(imread(path).std() > 0.05 for path in pictures)


def test_figures_stand_beside_the_papers_part_by_part() -> None:
    recording = still_recording("drawers")
    truth = recording.truth(0)
    rows = compare("recordings", [score(recording, [moved(truth, 6, 0)] * 3)])
    assert [row.part for row in rows] == ["lowest", "middle", "top", "base", "mean"]
    assert rows[2].paper.iou_percent == 89.8
    assert rows[2].measured.rotation_deg == pytest.approx(6, abs=1e-3)
    assert rows[4].paper.joint_cm == pytest.approx((0.37 + 0.36 + 0.28) / 3)
    (mean,) = over_categories(rows)
    assert (mean.category, mean.part, mean.paper.within_5deg_5cm_percent) == ("articulated", "mean of 1", 98.35)


def test_the_worst_moments_are_far_apart() -> None:
    recording = still_recording("camera", frames=60)
    truth = recording.truth(0)
    poses = [moved(truth, 1, 0)] * 59
    poses[30], poses[31], poses[50] = moved(truth, 20, 0), moved(truth, 19, 0), moved(truth, 10, 0)
    outcome = Outcome(Held(Sequence(recording, ())), Track(tuple(poses)), score(recording, poses))
    first, second, third, *_ = worst_moments([outcome])
    assert (first.frame, second.frame) == (31, 51)
    assert abs(third.frame - first.frame) >= APART
    assert first.badness == pytest.approx(4, abs=1e-2)


def test_states_are_drawn_in_stretches() -> None:
    states = (State.TRACKING, State.TRACKING, State.LOST, State.TRACKING)
    assert stretches(states) == [(0, 1, State.TRACKING), (2, 2, State.LOST), (3, 3, State.TRACKING)]
    assert stretches(()) == []
