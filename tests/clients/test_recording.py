"""A session is recorded, opens in viewers' terms, and replays to the last digit."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import orjson
import pytest
import typer
from google.protobuf.descriptor_pb2 import FileDescriptorSet
from google.protobuf.descriptor_pool import DescriptorPool
from google.protobuf.message_factory import GetMessageClass
from mcap.reader import make_reader
from mcap.records import Schema

from captra.data.recordings import RecordingError
from captra.recording.reader import messages
from captra.recording.writer import SessionWriter
from clients.cli import track
from clients.errors import ClientError, RequestRefusedError
from clients.playback import frames
from clients.replay import answers_in, replay
from clients.results import Result, parse_result
from clients.session import open_session
from tests.clients.sequences import DRIFT_M, FRAMES, drifting_mug, saved
from tests.service.support import Running

SHOWN = ("/cloud", "/tf", "/boxes", "/box_edges")


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
    x = [pair.recorded.parts[0].translation[0] for pair in pairs]
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


def by_its_schema(schema: Schema, data: bytes) -> Any:
    """A message as a reader that knows nothing but the file reads it."""
    pool = DescriptorPool()
    files = {each.name: each for each in FileDescriptorSet.FromString(schema.data).file}
    for name in sorted(files, key=lambda name: len(files[name].dependency)):
        pool.Add(files[name])
    return GetMessageClass(pool.FindMessageTypeByName(schema.name)).FromString(data)


def test_file_is_what_foxglove_and_rerun_know(recorded: Path) -> None:
    found: dict[str, list[Any]] = {}
    with recorded.open("rb") as file:
        for schema, channel, message in make_reader(file, validate_crcs=True).iter_messages():
            assert schema is not None
            if schema.name.startswith("captra."):
                assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
                continue
            assert (schema.encoding, channel.message_encoding) == ("protobuf", "protobuf"), "Rerun shows no JSON"
            found.setdefault(channel.topic, []).append(by_its_schema(schema, message.data))
    assert {topic: len(shown) for topic, shown in found.items()} == dict.fromkeys(SHOWN, FRAMES)
    cloud = found["/cloud"][0]
    assert cloud.frame_id == "camera"
    points = np.frombuffer(cloud.data, "<f4").reshape(-1, 3)
    np.testing.assert_array_equal(points, drifting_mug().clouds[0])
    (transform,) = found["/tf"][0].transforms
    assert (transform.parent_frame_id, transform.child_frame_id) == ("camera", "mug")
    assert transform.timestamp.ToNanoseconds() == cloud.timestamp.ToNanoseconds()
    (entity,) = found["/boxes"][0].entities
    position, translation = entity.cubes[0].pose.position, transform.translation
    assert position.SerializeToString() == translation.SerializeToString()
    edges = found["/box_edges"][0]
    assert [field.name for field in edges.fields] == ["x", "y", "z", "red", "green", "blue", "alpha"]
    drawn = np.frombuffer(edges.data, "<f4").reshape(-1, edges.point_stride // 4)[:, :3]
    size, middle = (np.array([each.x, each.y, each.z]) for each in (entity.cubes[0].size, position))
    np.testing.assert_allclose(np.ptp(drawn, axis=0), size, atol=1e-3)
    np.testing.assert_allclose((drawn.min(axis=0) + drawn.max(axis=0)) / 2, middle, atol=1e-3)


@pytest.mark.parametrize(
    ("content", "hint"), [(b"nothing of the kind", "record it again"), (b"", "ends too early.*record it again")]
)
def test_other_files_are_refused(url: str, tmp_path: Path, content: bytes, hint: str) -> None:
    path = tmp_path / "other.mcap"
    path.write_bytes(content)
    with pytest.raises(RecordingError, match=hint):
        replay(url, path, lambda _: None)


def test_a_session_without_frames_says_what_to_do(
    url: str, service: Running, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "empty.mcap"
    with open_session("mug", drifting_mug().init, url=url, record=path):
        pass
    with pytest.raises(typer.Exit) as ended:
        track([path], url=url)
    assert ended.value.exit_code == 1
    said = capsys.readouterr()
    assert "holds no frame that had a result" in said.err
    assert "record while clouds of the object are sent" in said.err
    assert "replayed" not in said.out
    assert service.http.get("/v1/sessions").json()["sessions"] == [], "nothing is left over"


def test_frames_that_are_not_answered_any_more_differ(url: str, recorded: Path) -> None:
    pair = replay(url, recorded, lambda _: None)[-1]
    assert not replace(pair, replayed=None).identical


def test_what_is_sent_by_http_is_recorded_too(url: str, tmp_path: Path) -> None:
    path, recording = tmp_path / "posted.mcap", drifting_mug()
    with open_session("mug", recording.init, url=url, record=path) as session:
        for cloud in recording.clouds[:3]:
            session.post(cloud)
        with pytest.raises(RequestRefusedError, match="near"):
            session.post(recording.clouds[3] + np.float32(2))
        list(session.track(list(frames(recording))[4:6]))
    names = [name for name, _ in messages(path)]
    assert (names.count("captra.Frame"), names.count("captra.Result")) == (6, 5)
    pairs = replay(url, path, lambda _: None)
    assert [pair.recorded.seq for pair in pairs] == [0, 1, 2, 4, 5]
    assert all(pair.identical for pair in pairs)


def test_stamps_of_an_array_are_recorded(url: str, tmp_path: Path) -> None:
    path, recording = tmp_path / "stamps.mcap", drifting_mug(2)
    with open_session("mug", recording.init, url=url, record=path) as session:
        assert session.put(recording.clouds[0], recording.stamps_ns[0]) == 0
        answer = session.receive()
        assert isinstance(answer, Result)
        assert answer.stamp_ns == recording.stamps_ns[0]
        assert session.post(recording.clouds[1], recording.stamps_ns[1]).stamp_ns == recording.stamps_ns[1]
    stamps = [body["stamp_ns"] for name, body in messages(path) if name == "captra.Frame"]
    assert stamps == recording.stamps_ns.tolist()


def test_frames_without_the_object_are_replayed_since_they_count(url: str, tmp_path: Path) -> None:
    path, recording = tmp_path / "missed.mcap", drifting_mug(12)
    clouds = [recording.clouds[0]] * 12
    for frame in range(2, 10):
        clouds[frame] = clouds[frame] + np.float32(2)
    with open_session("mug", recording.init, url=url, record=path) as session:
        results = list(session.track(clouds, on_event=lambda event: None))
    states = {result.seq: result.state for result in results}
    pairs = replay(url, path, lambda _: None)
    assert [pair.recorded.seq for pair in pairs] == [0, 1, 10, 11]
    assert [pair.recorded.state for pair in pairs] == [states[seq] for seq in (0, 1, 10, 11)]
    assert states[10] is not states[1], "misses change the state"
    assert all(pair.identical for pair in pairs)


@pytest.mark.parametrize(
    "order", [("frame", "event", "result"), ("result", "event", "frame"), ("frame", "result", "event")]
)
def test_a_state_that_is_told_of_a_miss_is_no_answer(order: tuple[str, ...], recorded: Path, tmp_path: Path) -> None:
    path = tmp_path / "any_order.mcap"
    (told, *_) = [body for name, body in messages(recorded) if name == "captra.Result"]
    missed = {"seq": 0, "kind": "rejected", "reason": "no-points-near-object"}
    writer = SessionWriter(path)
    for step in order:
        match step:
            case "frame":
                writer.frame(0, 0, "x", b"", b"", None)
            case "event":
                writer.event(orjson.dumps(missed))
            case "result":
                payload = orjson.dumps(told)
                writer.result(payload, parse_result(payload))
    writer.close()
    assert {number: answer.result for number, answer in answers_in(path).items()} == {1: None}


def test_several_recordings_go_into_several_files(url: str, tmp_path: Path) -> None:
    first, second = drifting_mug(3), replace(drifting_mug(4), name="mug__blob__other")
    track(
        [saved(first, tmp_path), saved(second, tmp_path)],
        url=url,
        as_fast_as_possible=True,
        record=tmp_path / "played.mcap",
    )
    for recording in (first, second):
        names = [name for name, _ in messages(tmp_path / f"played__{recording.name}.mcap")]
        assert names.count("captra.Result") == names.count("captra.Truth") == len(recording)
    assert not (tmp_path / "played.mcap").exists()


@pytest.mark.parametrize("given", [{"url": "http://127.0.0.1:9"}, {"category": "mugg"}, {"profile": "fast"}])
def test_a_recording_is_replaced_once_a_session_is_open(url: str, tmp_path: Path, given: dict[str, Any]) -> None:
    path, recording = tmp_path / "session.mcap", drifting_mug(3)
    path.write_bytes(b"an hour's work")
    arguments: dict[str, Any] = {"category": "mug", "pose": recording.init, "url": url, "record": path} | given
    with pytest.raises(ClientError):
        open_session(**arguments)
    assert [(each.name, each.read_bytes()) for each in tmp_path.iterdir()] == [(path.name, b"an hour's work")]
    with open_session("mug", recording.init, url=url, record=path) as session:
        list(session.track(frames(recording)))
    assert [each.name for each in tmp_path.iterdir()] == [path.name]
    assert [name for name, _ in messages(path)].count("captra.Result") == 3


def test_command_that_finds_no_service_leaves_the_recording_there(tmp_path: Path) -> None:
    played, record = saved(drifting_mug(3), tmp_path), tmp_path / "session.mcap"
    record.write_bytes(b"an hour's work")
    with pytest.raises(typer.Exit):
        track([played], url="http://127.0.0.1:9", record=record)
    assert record.read_bytes() == b"an hour's work"
    assert len(list(tmp_path.iterdir())) == 2


def test_a_recording_that_is_played_is_not_recorded_over(
    url: str, recorded: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    content, other = recorded.read_bytes(), saved(drifting_mug(3), recorded.parent)
    target = recorded.rename(recorded.with_name(f"played__{other.stem}.mcap"))
    with pytest.raises(typer.Exit):
        track([target, other], url=url, record=recorded.with_name("played.mcap"))
    assert "would overwrite" in capsys.readouterr().err
    assert target.read_bytes() == content
