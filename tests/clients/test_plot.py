"""`captra plot` draws what a file tells."""

from pathlib import Path

import numpy as np
import orjson
import pytest
import typer
from matplotlib.image import imread

from captra.health import State
from captra.recording.reader import messages
from clients.cli import track
from clients.history import history_of
from clients.plot import panels_of, plot
from tests.clients.sequences import DRIFT_M, FRAMES, drifting_mug, saved
from tests.service.support import running


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A recording with truth, and the same through the service."""
    folder = tmp_path_factory.mktemp("played")
    npz, mcap = saved(drifting_mug(), folder), folder / "mug.mcap"
    with running("mug") as started:
        assert started.service.readiness.wait_prepared(60)
        track([npz], url=str(started.http.base_url), as_fast_as_possible=True, record=mcap)
    return npz, mcap


def test_error_confidence_and_latency_are_drawn(files: tuple[Path, Path], tmp_path: Path) -> None:
    _, mcap = files
    history = history_of(mcap, None)
    assert len(history.results) == len(history.truth) == FRAMES
    errors = history.errors()
    assert errors is not None
    rotation_deg, translation_cm = errors
    np.testing.assert_allclose(rotation_deg, 0, atol=0.1)
    expected = [
        100 * np.linalg.norm(r.pose.translation - history.truth[r.stamp_ns].translation) for r in history.results
    ]
    np.testing.assert_allclose(translation_cm[:, 0], expected)
    panels = list(panels_of(history))
    assert [label for label, _, _ in panels] == [
        "rotation error, °", "translation error, cm", "confidence", "latency, ms",
    ]  # fmt: skip
    plot(mcap, out=tmp_path / "picture.png")
    picture = imread(tmp_path / "picture.png")
    assert picture.shape[0] > 800
    green = np.array([0xD9, 0xF2, 0xD9]) / 255
    assert {result.state for result in history.results} == {State.TRACKING}
    assert np.isclose(picture[..., :3], green, atol=0.01).all(axis=-1).mean() > 0.2, "the state is shaded"


def test_results_alone_are_drawn_without_error_or_with_a_recordings_truth(
    files: tuple[Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    npz, mcap = files
    results = [body for name, body in messages(mcap) if name == "captra.Result"]
    lines, listed = tmp_path / "lines.json", tmp_path / "list.json"
    lines.write_bytes(b"\n".join(orjson.dumps(result) for result in results))
    listed.write_bytes(orjson.dumps(results))
    assert history_of(lines, None).results == history_of(listed, None).results
    assert history_of(lines, None).errors() is None
    plot(lines)
    assert lines.with_suffix(".png").exists()
    assert "8 results, without truth" in capsys.readouterr().out
    with_truth = history_of(listed, drifting_mug()).errors()
    assert with_truth is not None
    assert with_truth[1].max() < 100 * DRIFT_M
    plot(listed, truth=npz)
    assert "without truth" not in capsys.readouterr().out


@pytest.mark.parametrize("content", [b"", b"[]", b"{", b"[1]", b'{"seq": 1}'])
def test_other_files_are_refused(content: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "other.json"
    path.write_bytes(content)
    with pytest.raises(typer.Exit):
        plot(path)
    assert str(path) in capsys.readouterr().err
