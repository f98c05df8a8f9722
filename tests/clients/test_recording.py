"""A session is recorded, opens in viewers' terms, and replays to the last digit."""

import base64
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader

from captra.data.recordings import RecordingError
from clients.cli import track
from clients.playback import frames
from clients.replay import replay
from clients.session import open_session
from tests.clients.sequences import DRIFT_M, FRAMES, drifting_mug
from tests.service.support import running


@pytest.fixture(scope="module")
def url() -> Iterator[str]:
    with running("mug") as started:
        assert started.service.readiness.wait_prepared(30)
        yield str(started.http.base_url)


@pytest.fixture
def recorded(url: str, tmp_path: Path) -> Path:
    path, recording = tmp_path / "session.mcap", drifting_mug()
    with open_session("mug", recording.init, url=url, record=path, frame_id="camera") as session:
        clouds = list(frames(recording))
        list(session.track(clouds[:4]))
        session.reset(recording.init)
        list(session.track(clouds[4:5]))
        list(session.track(clouds[5:]))
    return path


def test_replay_gives_the_same_poses_to_the_last_digit(url: str, recorded: Path) -> None:
    seen: list[int] = []
    pairs = replay(url, recorded, lambda result: seen.append(result.seq))
    assert seen == list(range(FRAMES))
    assert all(pair.identical for pair in pairs)
    x = [pair.replayed.parts[0].translation[0] for pair in pairs]
    assert x[3] - x[0] > 2 * DRIFT_M  # the poses are no constant


def test_another_last_digit_is_noticed(url: str, recorded: Path) -> None:
    pair = replay(url, recorded, lambda _: None)[-1]
    (part,) = pair.recorded.parts
    x, y, z = part.translation
    moved = replace(part, translation=(float(np.nextafter(x, 1)), y, z))
    assert pair.identical
    assert not replace(pair, recorded=replace(pair.recorded, parts=(moved,))).identical


def test_command_replays_a_file(url: str, recorded: Path, capsys: pytest.CaptureFixture[str]) -> None:
    track([recorded], url=url)
    assert f"{FRAMES} frames replayed, {FRAMES} with the same pose" in " ".join(capsys.readouterr().out.split())


def test_file_is_what_foxglove_and_rerun_know(recorded: Path) -> None:
    found: dict[str, list[dict[str, Any]]] = {}
    with recorded.open("rb") as file:
        for schema, channel, message in make_reader(file, validate_crcs=True).iter_messages():
            assert schema is not None
            assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
            found.setdefault(schema.name, []).append(json.loads(message.data))
    assert len(found["foxglove.PointCloud"]) == FRAMES
    cloud = found["foxglove.PointCloud"][0]
    assert cloud["frame_id"] == "camera"
    points = np.frombuffer(base64.b64decode(cloud["data"]), "<f4").reshape(-1, 3)
    np.testing.assert_array_equal(points, drifting_mug().clouds[0])
    (transform,) = found["foxglove.FrameTransforms"][0]["transforms"]
    assert (transform["parent_frame_id"], transform["child_frame_id"]) == ("camera", "mug")
    (entity,) = found["foxglove.SceneUpdate"][0]["entities"]
    assert entity["cubes"][0]["pose"]["position"] == transform["translation"]


def test_other_files_are_refused(url: str, tmp_path: Path) -> None:
    path = tmp_path / "other.mcap"
    path.write_bytes(b"nothing of the kind")
    with pytest.raises(RecordingError, match="record it again"):
        replay(url, path, lambda _: None)
