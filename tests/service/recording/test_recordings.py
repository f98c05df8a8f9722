"""Sessions that the service records itself: files are whole, limited, fetched by HTTP, and replay to the last digit."""

import os
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader

from captra.recording.reader import is_mcap, messages
from captra.recording.writer import SessionWriter
from clients.replay import replay
from service.codecs import CDR
from service.recording.folder import Recordings
from service.sqlite_store import SqliteSessionStore
from tests.service.ros2.clouds import cdr
from tests.service.support import Running, blob, f32, i16, running

PERIOD_NS = 33_000_000
I16 = "application/vnd.captra.cloud.i16"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "recordings"


@pytest.fixture
def recording(folder: Path) -> Iterator[Running]:
    with running("mug", record_dir=folder) as started:
        assert started.service.readiness.wait_prepared(60)
        yield started


def turned(angle: float) -> list[list[float]]:
    """A rotation whose numbers are not round."""
    c, s = float(np.cos(angle)), float(np.sin(angle))
    return [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]


def track_something(service: Running) -> str:
    part = {"rotation": {"matrix": turned(0.3)}, "translation": [0, 0, 0.5], "size": [0.1, 0.11, 0.12]}
    options: dict[str, Any] = {
        "frame_id": "camera_depth_optical_frame",
        "prediction": "constant-velocity",
        "smoothing": {},
    }
    opened = service.open_session(parts=[part], record=True, **options)
    session_id: str = opened["session_id"]
    for seq in range(4):
        sent = service.post_frame(session_id, f32(blob((0.003 * seq, 0, 0.5))), seq, stamp_ns=seq * PERIOD_NS)
        assert sent.status_code == 200
    assert service.post_frame(session_id, f32(blob((5, 5, 5))), 4).status_code == 422  # nothing near the object
    assert service.post_frame(session_id, b"123", 5).status_code == 422  # no cloud: the tracker never sees it
    service.post_frame(session_id, i16(blob((0.01, 0, 0.5))), 6, I16, stamp_ns=6 * PERIOD_NS)
    moved = {"parts": [part | {"rotation": {"matrix": turned(0.1)}}]}
    assert service.http.put(f"/v1/sessions/{session_id}/pose", json=moved).status_code == 200
    for seq in range(3):  # numbers start over
        sent = service.post_frame(session_id, f32(blob((0.004 * seq, 0.001, 0.5))), seq, stamp_ns=seq * PERIOD_NS)
        assert sent.status_code == 200
    service.http.delete(f"/v1/sessions/{session_id}")
    return session_id


def names(service: Running) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = service.http.get("/v1/recordings").json()["recordings"]
    return found


def test_whoever_shows_the_list_is_told_when_it_changes(recording: Running) -> None:
    def changes() -> int:
        return recording.service.recordings.changes

    before = changes()
    session_id: str = recording.open_session(record=True)["session_id"]
    assert changes() == before, "there is nothing to play before it is over"
    recording.http.delete(f"/v1/sessions/{session_id}")
    assert changes() == before + 1
    recording.http.delete(f"/v1/recordings/mug_{session_id}")
    assert changes() == before + 2


def test_a_recorded_session_is_fetched_and_replays_to_the_last_digit(recording: Running, tmp_path: Path) -> None:
    session_id = track_something(recording)
    (entry,) = names(recording)
    assert (entry["name"], entry["finished"]) == (f"mug_{session_id}", True)
    answer = recording.http.get(f"/v1/recordings/{entry['name']}")
    assert answer.headers["content-type"] == "application/vnd.mcap"
    assert len(answer.content) == entry["size_bytes"]
    path = tmp_path / entry["name"]  # as curl -O saves it
    assert f'filename="{entry["name"]}.mcap"' in answer.headers["content-disposition"]
    path.write_bytes(answer.content)
    assert is_mcap(path)
    pairs = replay(str(recording.http.base_url), path, lambda result: None)
    assert [pair.recorded.seq for pair in pairs] == [0, 1, 2, 3, 6, 0, 1, 2]
    assert all(pair.identical for pair in pairs)
    kinds = [name for name, _ in messages(path)]
    assert kinds.count("captra.Reset") == 1
    events = [body for name, body in messages(path) if name == "captra.Event"]
    assert events[-1]["kind"] == "closing"


def test_a_point_cloud2_is_kept_once_and_replays(recording: Running, folder: Path) -> None:
    session_id = recording.open_session(record=True)["session_id"]
    for seq in range(3):
        sent = recording.post_frame(session_id, cdr(blob((0.004 * seq, 0, 0.5), points=2000)), seq, CDR)
        assert sent.status_code == 200
    recording.http.delete(f"/v1/sessions/{session_id}")
    path = folder / f"mug_{session_id}.mcap"
    with path.open("rb") as file:
        found = [(channel.topic, message.data) for _, channel, message in make_reader(file).iter_messages()]
    clouds = [data for topic, data in found if topic == "/cloud"]
    assert clouds == [cdr(blob((0.004 * seq, 0, 0.5), points=2000)) for seq in range(3)]
    assert max(len(data) for topic, data in found if topic == "/captra/frames") < 200
    pairs = replay(str(recording.http.base_url), path, lambda result: None)
    assert [pair.identical for pair in pairs] == [True] * 3


def test_what_is_not_recorded_leaves_no_file(recording: Running, folder: Path) -> None:
    session_id = recording.open_session()["session_id"]
    recording.post_frame(session_id, f32(blob()))
    recording.http.delete(f"/v1/sessions/{session_id}")
    assert names(recording) == []
    assert not folder.exists()


def test_a_recording_at_work_is_listed_and_cannot_be_fetched(recording: Running) -> None:
    session_id = recording.open_session(record=True)["session_id"]
    (entry,) = names(recording)
    assert entry["finished"] is False
    for method in ("GET", "DELETE"):
        answer = recording.http.request(method, f"/v1/recordings/{entry['name']}")
        assert (answer.status_code, answer.json()["reason"]) == (409, "unfinished-recording")
    recording.http.delete(f"/v1/sessions/{session_id}")
    assert recording.http.delete(f"/v1/recordings/{entry['name']}").status_code == 204
    assert names(recording) == []


@pytest.mark.parametrize("name", ["nothing", "..%2F..%2Fetc%2Fpasswd", "a.mcap", "%00"])
def test_names_of_no_recording_lead_nowhere(recording: Running, name: str) -> None:
    answer = recording.http.get(f"/v1/recordings/{name}")
    assert answer.status_code == 404
    assert answer.json()["reason"] in {"unknown-recording", "not-found"}


def test_a_recording_ends_at_its_size_and_the_session_goes_on(folder: Path) -> None:
    with running("mug", record_dir=folder, record_max_bytes=2**20, record_max_total_bytes=2**21) as service:
        assert service.service.readiness.wait_prepared(60)
        session_id = service.open_session(record=True)["session_id"]
        noise = np.random.default_rng(0).uniform(-0.05, 0.05, (40_000, 3)) + (0, 0, 0.5)
        for seq in range(8):
            assert service.post_frame(session_id, f32(noise), seq).status_code == 200
        service.http.delete(f"/v1/sessions/{session_id}")
        (entry,) = names(service)
        assert entry["finished"]
        assert 2**20 <= entry["size_bytes"] < 2**22
        seqs = [body["seq"] for name, body in messages(folder / f"{entry['name']}.mcap") if name == "captra.Frame"]
        assert 0 < len(seqs) < 8
        answer = service.http.post("/v1/sessions", json=session_body_recorded())
        assert (answer.status_code, answer.json()["reason"]) == (507, "recordings-full")
        assert "CAPTRA_RECORD_MAX_TOTAL_BYTES" in answer.json()["detail"]
        assert service.http.get("/v1/sessions").json() == {"sessions": []}
        service.http.delete(f"/v1/recordings/{entry['name']}")
        assert service.http.post("/v1/sessions", json=session_body_recorded()).status_code == 201


def session_body_recorded() -> dict[str, Any]:
    part = {"rotation": {"quat_xyzw": [0, 0, 0, 1]}, "translation": [0, 0, 0.5], "size": [0.1, 0.1, 0.1]}
    return {"category": "mug", "parts": [part], "record": True}


def test_sessions_share_the_room_that_there_is_and_none_is_refused_for_what_others_might_take(folder: Path) -> None:
    with running("mug", record_dir=folder, record_max_total_bytes=4 * 2**20) as service:
        assert service.service.readiness.wait_prepared(60)
        opened = [service.open_session(record=True)["session_id"] for _ in range(6)]
        noise = np.random.default_rng(0).uniform(-0.05, 0.05, (40_000, 3)) + (0, 0, 0.5)
        for seq in range(8):
            for session_id in opened:
                assert service.post_frame(session_id, f32(noise), seq).status_code == 200
        for session_id in opened:
            service.http.delete(f"/v1/sessions/{session_id}")
        entries = names(service)
        assert len(entries) == 6
        assert all(entry["finished"] for entry in entries)
        assert 4 * 2**20 <= sum(entry["size_bytes"] for entry in entries) < 12 * 2**20
        answer = service.http.post("/v1/sessions", json=session_body_recorded())
        assert (answer.status_code, answer.json()["reason"]) == (507, "recordings-full")


def test_sessions_that_are_refused_leave_no_recording(folder: Path) -> None:
    with running("mug", record_dir=folder, max_sessions=1) as service, ThreadPoolExecutor(8) as clients:
        assert service.service.readiness.wait_prepared(60)
        posts = [clients.submit(service.http.post, "/v1/sessions", json=session_body_recorded()) for _ in range(8)]
        assert sorted(post.result().status_code for post in posts) == [201, *[429] * 7]
        assert len(names(service)) == 1


def test_what_another_service_is_recording_is_left_to_it(folder: Path, recording: Running) -> None:
    session_id = recording.open_session(record=True)["session_id"]
    with running("mug", record_dir=folder) as other:
        assert other.service.readiness.wait_prepared(60)
        (entry,) = names(other)
        assert not entry["finished"]
        answer = other.http.delete(f"/v1/recordings/{entry['name']}")
        assert (answer.status_code, answer.json()["reason"]) == (409, "unfinished-recording")
    recording.post_frame(session_id, f32(blob()))
    recording.http.delete(f"/v1/sessions/{session_id}")
    assert [body["seq"] for kind, body in messages(folder / f"mug_{session_id}.mcap") if kind == "captra.Result"] == [0]


def test_what_was_broken_off_takes_room_and_can_be_deleted(folder: Path) -> None:
    folder.mkdir()
    (folder / "mug_died.mcap.part").write_bytes(bytes(2**21))
    with running("mug", record_dir=folder, record_max_total_bytes=2**21) as service:
        assert service.service.readiness.wait_prepared(60)
        answer = service.http.get("/v1/recordings/mug_died")
        assert (answer.status_code, answer.json()["reason"]) == (409, "unfinished-recording")
        assert service.http.post("/v1/sessions", json=session_body_recorded()).status_code == 507
        deadline_s = time.monotonic() + 10  # until it was tried to be made whole
        while service.http.delete("/v1/recordings/mug_died").status_code != 204 and time.monotonic() < deadline_s:
            time.sleep(0.05)
        assert names(service) == []
        assert service.http.post("/v1/sessions", json=session_body_recorded()).status_code == 201


def test_a_folder_that_cannot_be_written_is_told_before_anything_is_lost(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    with running("mug", record_dir=tmp_path / "file" / "recordings") as service:
        assert service.service.readiness.wait_prepared(60)
        answer = service.http.post("/v1/sessions", json=session_body_recorded())
        assert (answer.status_code, answer.json()["reason"]) == (503, "not-stored")
        assert "CAPTRA_RECORD_DIR" in answer.json()["detail"]


def test_a_session_that_goes_on_after_a_restart_is_recorded_into_one_more_file(folder: Path, tmp_path: Path) -> None:
    database = tmp_path / "sessions.sqlite"
    with running("mug", record_dir=folder, store=SqliteSessionStore(database)) as service:
        assert service.service.readiness.wait_prepared(60)
        session_id = service.open_session(record=True)["session_id"]
        service.post_frame(session_id, f32(blob()), 0)
    with running("mug", record_dir=folder, store=SqliteSessionStore(database)) as service:
        assert service.service.readiness.wait_prepared(60)
        assert service.post_frame(session_id, f32(blob()), 1).status_code == 200
        service.http.delete(f"/v1/sessions/{session_id}")
        assert [entry["name"] for entry in names(service)] == [f"mug_{session_id}", f"mug_{session_id}-2"]
    for name, seq in ((f"mug_{session_id}", 0), (f"mug_{session_id}-2", 1)):
        assert [b["seq"] for kind, b in messages(folder / f"{name}.mcap") if kind == "captra.Result"] == [seq]


def test_what_a_process_that_died_has_left_behind_is_made_whole(folder: Path) -> None:
    with running("mug", record_dir=folder) as service:
        assert service.service.readiness.wait_prepared(60)
        session_id = service.open_session(record=True)["session_id"]
        noise = np.random.default_rng(0).uniform(-0.05, 0.05, (40_000, 3)) + (0, 0, 0.5)
        for seq in range(6):
            service.post_frame(session_id, f32(noise), seq)
        service.http.delete(f"/v1/sessions/{session_id}")
    whole = folder / f"mug_{session_id}.mcap"
    content = whole.read_bytes()
    whole.unlink()
    (folder / "mug_died.mcap.part").write_bytes(content[: len(content) * 2 // 3])
    (folder / "mug_empty.mcap.part").write_bytes(b"")
    with running("mug", record_dir=folder) as service:
        wait_until_finished(service, "mug_died")
        assert [(entry["name"], entry["finished"]) for entry in names(service)] == [
            ("mug_died", True), ("mug_empty", False),
        ]  # fmt: skip
    seqs = [body["seq"] for name, body in messages(folder / "mug_died.mcap") if name == "captra.Frame"]
    assert seqs == list(range(len(seqs)))
    assert 0 < len(seqs) < 6


def test_a_damaged_file_keeps_neither_sessions_nor_other_files_from_going_on(folder: Path, tmp_path: Path) -> None:
    database = tmp_path / "sessions.sqlite"
    with running("mug", record_dir=folder, store=SqliteSessionStore(database)) as service:
        recorded_id = service.open_session(record=True)["session_id"]
        for seq in range(40):
            noise = np.random.default_rng(seq).uniform(-0.05, 0.05, (10_000, 3)) + (0, 0, 0.5)
            service.post_frame(recorded_id, f32(noise), seq)
        service.http.delete(f"/v1/sessions/{recorded_id}")
        session_id = service.open_session()["session_id"]
    content = (folder / f"mug_{recorded_id}.mcap").read_bytes()
    half = len(content) // 2
    for name, damaged in (
        ("mug_1_zeros", content[:half] + bytes(half)),
        ("mug_2_nothing", bytes(4096)),
        ("mug_3_cut", content[:half]),
    ):
        (folder / f"{name}.mcap.part").write_bytes(damaged)
    with running("mug", record_dir=folder, store=SqliteSessionStore(database)) as service:
        assert service.service.readiness.wait_prepared(60)
        service.service.readiness.check()
        assert service.http.get(f"/v1/sessions/{session_id}").status_code == 200
        wait_until_finished(service, "mug_3_cut")
        finished = {entry["name"]: entry["finished"] for entry in names(service) if entry["name"].count("_") == 2}
        assert finished == {"mug_1_zeros": True, "mug_2_nothing": False, "mug_3_cut": True}
        assert {path.suffix for path in folder.iterdir()} == {".mcap", ".part"}
    for name in ("mug_1_zeros", "mug_3_cut"):
        assert any(kind == "captra.Frame" for kind, _ in messages(folder / f"{name}.mcap"))


def test_sessions_go_on_before_what_was_left_behind_is_read(folder: Path, tmp_path: Path) -> None:
    database = tmp_path / "sessions.sqlite"
    with running("mug", record_dir=folder, store=SqliteSessionStore(database)) as service:
        session_id = service.open_session(record=True)["session_id"]
    endless, died = folder / "mug_0.mcap.part", folder / f"mug_{session_id}.mcap"
    os.mkfifo(endless)  # whoever opens it waits for what somebody writes
    died.rename(died.with_suffix(".mcap.part"))
    with running("mug", record_dir=folder, store=SqliteSessionStore(database)) as service:
        assert service.service.readiness.wait_prepared(60)
        service.service.readiness.check()
        assert service.post_frame(session_id, f32(blob()), 0).status_code == 200
        endless.open("wb").close()
        wait_until_finished(service, f"mug_{session_id}")
        service.http.delete(f"/v1/sessions/{session_id}")
    found = [body["seq"] for name, body in messages(folder / f"mug_{session_id}-2.mcap") if name == "captra.Result"]
    assert found == [0]


def wait_until_finished(service: Running, name: str) -> None:
    deadline = time.monotonic() + 60
    while (name, True) not in [(entry["name"], entry["finished"]) for entry in names(service)]:
        assert time.monotonic() < deadline, f"{name} was never finished"
        time.sleep(0.02)


def test_no_listing_overlooks_a_recording_that_becomes_whole_meanwhile(tmp_path: Path) -> None:
    writer = SessionWriter(tmp_path / "written")
    writer.session({"category": "mug"})
    writer.close()
    names = {f"mug_{number}" for number in range(100)}
    for name in names:
        (tmp_path / f"{name}.mcap.part").write_bytes((tmp_path / "written").read_bytes())
    recordings = Recordings(tmp_path, 2**30, 2**30)
    with ThreadPoolExecutor(1) as pool:
        done = pool.submit(recordings.salvage, recordings.left_behind())
        while not done.done():
            assert sorted(each.name for each in recordings.all()) == sorted(names)
    assert all(each.finished for each in recordings.all())


def test_a_recording_that_somebody_deletes_while_it_is_written_is_let_go(recording: Running, folder: Path) -> None:
    session_id = recording.open_session(record=True)["session_id"]
    (folder / f"mug_{session_id}.mcap.part").unlink()
    recording.http.delete(f"/v1/sessions/{session_id}")
    assert names(recording) == []
    session_id = recording.open_session(record=True)["session_id"]
    recording.http.delete(f"/v1/sessions/{session_id}")
    assert [(entry["name"], entry["finished"]) for entry in names(recording)] == [(f"mug_{session_id}", True)]
