"""Every numbered example runs as its docstring says, against a service with the networks that ship."""

import ast
import csv
import runpy
import shlex
import shutil
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import orjson
import pytest
from mcap.writer import Writer

from captra.data.recordings import load_recording
from captra.recording.writer import POINT_CLOUD2, definition_of
from clients.demo import COFFEE_MUG
from clients.rest import session_body
from clients.service_process import ServiceProcess
from tests.clients.sequences import first_frames, saved
from tests.service.ros2.clouds import cdr
from tests.service.support import running

ROOT = Path(__file__).parents[3]
EXAMPLES = sorted((ROOT / "clients" / "examples").glob("[0-9]*.py"))
FRAMES = 8

Run = Callable[..., list[str]]


def usage(example: Path) -> list[str]:
    """The words after `python` in an example's docstring."""
    docstring = ast.get_docstring(ast.parse(example.read_text())) or ""
    (line,) = [line.strip() for line in docstring.splitlines() if line.strip().startswith("python ")]
    return shlex.split(line)[1:]


@pytest.fixture(scope="module")
def url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    models = tmp_path_factory.mktemp("models")
    for category in ("mug", "scissors"):
        shutil.copytree(ROOT / "models" / category, models / category)
    with ServiceProcess({"CAPTRA_MODELS_DIR": str(models), "CAPTRA_ROS2": "true"}) as service:
        yield service.url


@pytest.fixture
def run(url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    def run_example(name: str, frames: int = FRAMES, at: str = url, words: Sequence[str] = ()) -> list[str]:
        """`words` take the place of those in the docstring."""
        (example,) = [path for path in EXAMPLES if path.name.startswith(name)]
        script, recording, *others = usage(example)
        assert ROOT / script == example
        monkeypatch.setenv("CAPTRA_URL", at)
        if not words:
            short = saved(first_frames(load_recording(ROOT / recording), frames), tmp_path)
            words = (str(short), *(str(tmp_path / other) for other in others))
        monkeypatch.setattr(sys, "argv", [script, *words])
        runpy.run_path(str(example), run_name="__main__")
        return capsys.readouterr().out.splitlines()

    return run_example


def test_each_is_tested_and_says_how_it_is_called() -> None:
    tested = Path(__file__).read_text()
    for number, example in enumerate(EXAMPLES):
        assert example.name.startswith(f"{number:02d}_"), "numbered without gaps"
        assert f'run("{number:02d}' in tested, example.name
        assert usage(example)[0] == example.relative_to(ROOT).as_posix()


def test_track_a_recording(run: Run) -> None:
    lines = run("00")
    assert len(lines) == FRAMES
    assert " tracking " in lines[-1]


def test_depth_camera(run: Run) -> None:
    lines = run("01")
    assert len(lines) == FRAMES
    assert lines[-1].startswith("camera_depth_optical_frame at ")
    assert "tracking" in lines[-1]


def test_first_pose_of_ones_own(run: Run) -> None:
    *_, last = run("02")
    assert "tracking" in last
    assert float(last.split()[-5]) < 2.0, last


def test_joints(run: Run) -> None:
    with running("scissors") as service:
        assert service.service.readiness.wait_prepared(30)
        parts, *lines = run("03", at=str(service.http.base_url))
    assert parts == "parts: right_half, left_half"
    assert len(lines) == FRAMES
    assert all("pivot " in line for line in lines)


def test_health(run: Run) -> None:
    lines = run("04", frames=36)
    assert any(line.startswith("frame 15: use it") for line in lines)
    assert any(line.startswith("event: rejected no-points-near-object") for line in lines)
    assert not any(line.startswith("frame 25: use it") for line in lines)
    assert lines[-1].startswith("started again ")


def test_several_objects(run: Run) -> None:
    *_, last = run("05")
    first, second = (float(half.split(" at ")[1].split()[0]) for half in last.split("   "))
    assert second - first == pytest.approx(0.5, abs=0.02)


def test_http_only(run: Run) -> None:
    lines = run("06")
    assert len(lines) == FRAMES
    assert lines[-1].startswith(f"{FRAMES - 1} tracking [")


def test_poses_to_csv(run: Run, tmp_path: Path) -> None:
    run("07")
    with (tmp_path / "poses.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [int(row["seq"]) for row in rows] == list(range(FRAMES))
    assert {row["part"] for row in rows} == {"mug"}
    assert float(rows[-1]["size_y"]) > 0.05


def test_record_and_replay(run: Run) -> None:
    lines = run("08")
    assert len(lines) == FRAMES
    assert all(line.endswith("tracking the same") for line in lines[2:])


def test_masks(run: Run) -> None:
    lines = run("09")
    assert len(lines) == FRAMES
    assert all("tracking" in line for line in lines[2:])
    assert float(lines[-1].split()[-2]) == pytest.approx(0.43, abs=0.03), "the object, not the table behind it"


def test_ros2(run: Run) -> None:
    lines = run("10")
    assert len(lines) == FRAMES
    assert all(line.startswith("camera_depth_optical_frame -> cup/mug: ") for line in lines)
    assert float(lines[-1].split()[-2]) == pytest.approx(0.98, abs=0.05), "metres to the mug"


def test_ros2_bag(run: Run, tmp_path: Path) -> None:
    bag, session, recording = tmp_path / "bag.mcap", tmp_path / "session.json", load_recording(COFFEE_MUG)
    with bag.open("wb") as file:
        writer = Writer(file)
        writer.start(profile="ros2", library="libmcap")
        schema = writer.register_schema(POINT_CLOUD2, "ros2msg", definition_of(POINT_CLOUD2))
        channels = [
            writer.register_channel(topic, "cdr", schema) for topic in ("/other/points", "/camera/depth/points")
        ]
        for number, cloud in enumerate(recording.clouds[:FRAMES]):
            message = cdr(cloud, (("x", "f4"), ("y", "f4"), ("z", "f4"), ("rgb", "f4")))
            for channel in channels:
                writer.add_message(channel, number, message, number)
        writer.finish()  # type: ignore[no-untyped-call]
    session.write_bytes(orjson.dumps(session_body("mug", recording.init, {})))
    lines = run("11", words=[str(bag), "/camera/depth/points", str(session)])
    assert len(lines) == FRAMES
    assert all(" camera_depth_optical_frame: mug tracking at " in line for line in lines[2:])
    assert float(lines[-1].split()[-2]) == pytest.approx(0.98, abs=0.05), "metres to the mug"
    with pytest.raises(SystemExit, match="has no messages on /nowhere"):
        run("11", words=[str(bag), "/nowhere", str(session)])
