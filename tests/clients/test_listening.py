"""`captra record` hears sessions that others opened, over real sockets."""

import signal
import subprocess
import sys
import threading
import time
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
import typer
from mcap.reader import make_reader

from captra.geometry import Pose
from captra.recording.reader import messages
from clients import Camera, DepthImage, Smoothing
from clients.listening import listen_to
from clients.overheard import mask_in
from clients.packing import Observation
from clients.playback import frames
from clients.record import record
from clients.regions import PACKED_BOX
from clients.replay import replay
from clients.rest import RestApi
from clients.session import open_session
from tests.clients.sequences import FRAMES, drifting_mug
from tests.clients.test_recording import by_its_schema

LISTENS_S = 20
"""Time enough on a machine that does much else."""


class Listener:
    """`captra record` on a thread."""

    def __init__(self, url: str, folder: Path, sessions: list[str]) -> None:
        self.lines: list[str] = []
        self._told = threading.Semaphore(0)
        self._thread = threading.Thread(target=self._run, args=(url, folder, sessions))
        self._thread.start()

    def wait_told(self) -> None:
        assert self._told.acquire(timeout=20), "nothing was told"

    def wait_recording(self, session_id: str) -> None:
        while not any(session_id in line and line.endswith("recording") for line in list(self.lines)):
            self.wait_told()

    def join(self) -> None:
        self._thread.join(40)
        assert not self._thread.is_alive()

    def _run(self, url: str, folder: Path, sessions: list[str]) -> None:
        with closing(RestApi(url)) as api:
            listen_to(api, sessions, folder, self._tell, until_s=LISTENS_S)

    def _tell(self, line: str) -> None:
        self.lines.append(line)
        self._told.release()


def test_one_session_is_recorded_until_it_is_closed(url: str, tmp_path: Path) -> None:
    recording = drifting_mug()
    with open_session("mug", recording.init, url=url, frame_id="camera") as session:
        listener = Listener(url, tmp_path, [session.session_id])
        listener.wait_told()
        list(session.track(frames(recording)))
        path = tmp_path / f"mug_{session.session_id}.mcap"
    listener.join()
    found = [name for name, _ in messages(path)]
    assert found.count("captra.Frame") == found.count("captra.Result") == FRAMES
    assert listener.lines == [f"{path}: recording", f"session {path.stem[4:]}: complete"]
    pairs = replay(url, path, lambda result: None)
    assert len(pairs) == FRAMES
    for pair in pairs:
        assert pair.replayed is not None
        np.testing.assert_allclose(pair.replayed.pose.translation, pair.recorded.pose.translation, atol=1e-9)


def test_all_sessions_are_recorded_also_those_that_are_opened_later(url: str, tmp_path: Path) -> None:
    recording = drifting_mug()
    with open_session("mug", recording.init, url=url) as first:
        listener = Listener(url, tmp_path, [])
        listener.wait_recording(first.session_id)
        with open_session("mug", recording.init, url=url) as second:
            listener.wait_recording(second.session_id)
            list(second.track(list(frames(recording))[:3]))
        list(first.track(list(frames(recording))[:2]))
    listener.join()
    for session, count in ((first, 2), (second, 3)):
        found = [name for name, _ in messages(tmp_path / f"mug_{session.session_id}.mcap")]
        assert found.count("captra.Result") == count


def test_a_session_that_is_opened_later_replays_to_the_last_digit(url: str, tmp_path: Path) -> None:
    recording = drifting_mug()
    listener = Listener(url, tmp_path, [])
    listener.wait_told()  # that there is nothing yet, which is said by who listens
    with open_session("mug", recording.init, url=url, prediction="none", smoothing=Smoothing(2.0)) as session:
        clouds = list(frames(recording))
        list(session.track(clouds[:5]))
        session.reset(recording.init)
        time.sleep(0.5)
        list(session.track(clouds[5:]))
    listener.join()
    path = tmp_path / f"mug_{session.session_id}.mcap"
    (body,) = [body for name, body in messages(path) if name == "captra.Session"]
    assert (body["prediction"], body["smoothing"]["cutoff_hz"]) == ("none", 2.0)
    assert [name for name, _ in messages(path)].count("captra.Reset") == 1
    pairs = replay(url, path, lambda result: None)
    assert len(pairs) == FRAMES
    assert all(pair.identical for pair in pairs)


def test_depth_images_are_shown_with_the_camera_of_their_session(url: str, tmp_path: Path) -> None:
    camera = Camera(fx=60, fy=60, cx=31.5, cy=23.5, width=64, height=48)
    pixels = np.zeros((48, 64), np.uint16)
    pixels[20:28, 28:36] = 500
    pose = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0.0, 0.5]]), np.full((1, 3), 0.1))
    image = DepthImage(pixels)
    images: list[Observation] = [image, image.to_png(), DepthImage(pixels.astype(np.float32) / 1000)]
    with open_session("mug", pose, url=url, camera=camera) as session:
        listener = Listener(url, tmp_path, [session.session_id])
        listener.wait_told()
        list(session.track(images))
    listener.join()
    path, seen = tmp_path / f"mug_{session.session_id}.mcap", []
    with path.open("rb") as file:
        for schema, _, message in make_reader(file).iter_messages(topics=["/cloud"]):
            assert schema is not None
            seen.append(np.frombuffer(by_its_schema(schema, message.data).data, "<f4").reshape(-1, 3))
    assert [len(points) for points in seen] == [64, 64, 64]
    for points in seen:
        np.testing.assert_allclose(points.mean(axis=0), (0, 0, 0.5), atol=1e-6)
    assert all(pair.identical for pair in replay(url, path, lambda result: None))


def test_command_waits_for_a_session(url: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    record(out=tmp_path / "new", seconds=0.1, url=url)
    assert "waiting for one" in capsys.readouterr().out
    assert list((tmp_path / "new").iterdir()) == []


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_command_that_is_stopped_completes_its_files(url: str, tmp_path: Path, number: signal.Signals) -> None:
    recording = drifting_mug()
    with open_session("mug", recording.init, url=url) as session:
        command = [sys.executable, "-m", "captra", "record", "--out", str(tmp_path), "--url", url]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            assert process.stdout.readline().endswith("recording\n")
            list(session.track(frames(recording)))
            process.send_signal(number)
            assert process.wait(LISTENS_S) == 0
            assert process.stdout.read() == f"session {session.session_id}: complete\n"
    with (tmp_path / f"mug_{session.session_id}.mcap").open("rb") as file:
        assert make_reader(file).get_summary() is not None, "the index is there"


def test_command_that_cannot_write_a_file_says_so(url: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with open_session("mug", drifting_mug().init, url=url) as session:
        path = tmp_path / f"mug_{session.session_id}.mcap"
        path.mkdir()
        with pytest.raises(typer.Exit):
            record([session.session_id], out=tmp_path, url=url)
    assert f"cannot record into {path} (Is a directory): name a file" in capsys.readouterr().err


def test_secrets_are_not_recorded() -> None:
    secret, box = b"s" * 16, PACKED_BOX.pack(1, 2, 30, 40)
    png = b"\x89PNG\r\n\x1a\nwhatever" + bytes(4) + b"IEND\xae\x42\x60\x82"
    for mask in (b"", box, png):
        assert mask_in(mask) == mask
        assert mask_in(mask + secret) == mask
