from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from captra.data.recordings import RecordingError, load_recording
from captra.health import State
from clients import Event, Result, open_session
from clients.errors import NoResultError
from clients.playback import Playback, frame_rate_hz, frames, play, play_through
from clients.results import JointState, PartPose, Timing
from tests.clients.fake_service import FakeService, at_centroid
from tests.clients.sequences import DRIFT_M, drifting_mug, first_frames, saved


def result(seq: int, x: float, state: State = State.TRACKING, quat_xyzw: tuple[float, ...] = (0, 0, 0, 1)) -> Result:
    part = PartPose("object", (x, 0.0, 0.6), quat_xyzw, (0.1, 0.1, 0.1))
    joint = JointState("hinge", "revolute", 0.0)
    timing = Timing(0.0, 1.0, 2.0, 3.0, 6.0)
    return Result("s", seq, 20_000_000 * seq, "", state, 0.9, (part,), (joint,), timing, round_trip_ms=7.0)


def perfect(count: int = 8) -> list[Result]:
    return [result(seq, 0.02 + DRIFT_M * seq) for seq in range(count)]


def playback(results: list[Result], rejections: tuple[Event, ...] = ()) -> Playback:
    return Playback(drifting_mug(), tuple(results), rejections, elapsed_s=0.5)


def test_frame_rate_is_that_of_the_stamps() -> None:
    assert frame_rate_hz(drifting_mug()) == pytest.approx(50.0)


def test_frames_carry_the_recorded_stamps() -> None:
    assert [frame.stamp_ns for frame in frames(drifting_mug(3))] == [0, 20_000_000, 40_000_000]


def test_every_frame_but_the_first_has_the_pose_known_then() -> None:
    answered = [each for each in perfect() if each.seq not in (3, 4)]
    xs = [pose.translation[0, 0] for pose in playback(answered).poses()]
    assert np.allclose(xs, [0.03, 0.04, 0.04, 0.04, 0.07, 0.08, 0.09])


def test_before_the_first_result_the_given_pose_holds() -> None:
    xs = [pose.translation[0, 0] for pose in playback(perfect()[2:]).poses()]
    assert np.allclose(xs[:2], [0.02, 0.04])


@pytest.mark.parametrize("rate_hz", [None, 50.0])
def test_playing_shows_every_result_as_it_comes(fake: FakeService, rate_hz: float | None) -> None:
    recording, seen = drifting_mug(), list[Result]()
    with open_session("mug", recording.init, url=fake.url) as session:
        played = play(session, recording, rate_hz, seen.append)
    assert list(played.results) == seen
    assert [each.stamp_ns for each in seen][-1] == recording.stamps_ns[-1]
    assert played.rejections == ()
    assert played.elapsed_s >= (0 if rate_hz is None else 7 / 50)


@pytest.mark.parametrize("count", [0, 1])
def test_recordings_with_nothing_to_play_are_refused(fake: FakeService, tmp_path: Path, count: int) -> None:
    recording = load_recording(saved(first_frames(drifting_mug(), count), tmp_path))
    with pytest.raises(RecordingError, match=rf"holds {count} frames: at least 2 .* record it again"):
        play_through(fake.url, recording, print, as_fast_as_possible=True)
    assert fake.requests == []


def test_a_recording_of_nothing_says_why_no_frame_had_a_result(tmp_path: Path) -> None:
    def reject(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        return {"kind": "rejected", "reason": "no-points", "detail": f"the cloud has {len(points)} points: send some"}

    recording = drifting_mug(3)
    clouds = tuple(np.zeros((0, 3), np.float32) for _ in recording.clouds)
    path = saved(replace(recording, clouds=clouds, labels=tuple(np.zeros(0, np.uint8) for _ in clouds)), tmp_path)
    with FakeService(reject) as fake, pytest.raises(NoResultError, match=r"not one of the 3 .* 0 points: send some"):
        play_through(fake.url, load_recording(path), print, as_fast_as_possible=True)


def test_rejections_are_kept_and_do_not_end_the_playing() -> None:
    def reject_third(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        if seq == 3:
            return {"kind": "rejected", "reason": "no-points-near-object", "detail": "nothing is near"}
        return at_centroid(service, seq, points)

    recording = drifting_mug()
    with FakeService(reject_third) as fake, open_session("mug", recording.init, url=fake.url) as session:
        played = play(session, recording, None, lambda result: None)
    assert [event.seq for event in played.rejections] == [3]
    assert len(played.results) == 7
