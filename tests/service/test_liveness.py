import pytest

from service.liveness import CloseReason, Liveness


class Clock:
    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def liveness(clock: Clock) -> Liveness:
    return Liveness(idle_timeout_s=60, client_grace_s=10, clock_s=clock)


def test_idle_session_expires(liveness: Liveness, clock: Clock) -> None:
    clock.now_s += 59
    assert liveness.expired() is None
    assert liveness.expires_after_s == pytest.approx(1)
    clock.now_s += 1
    assert liveness.expired() is CloseReason.IDLE
    assert liveness.expires_after_s == 0


def test_frames_keep_it_alive(liveness: Liveness, clock: Clock) -> None:
    clock.now_s += 59
    liveness.touch()
    clock.now_s += 59
    assert liveness.expired() is None


def test_client_that_is_gone_takes_its_session_after_the_grace_time_and_not_before(
    liveness: Liveness, clock: Clock
) -> None:
    liveness.client_gone()
    clock.now_s += 9.9
    assert liveness.expired() is None
    clock.now_s += 0.1
    assert liveness.expired() is CloseReason.CLIENT_GONE


def test_client_that_comes_back_keeps_its_session(liveness: Liveness, clock: Clock) -> None:
    liveness.client_gone()
    clock.now_s += 5
    liveness.client_back()
    clock.now_s += 30
    assert liveness.expired() is None


def test_last_frame_in_flight_only_puts_the_end_off(liveness: Liveness, clock: Clock) -> None:
    liveness.client_gone()
    clock.now_s += 1
    liveness.touch()
    clock.now_s += 9.5
    assert liveness.expired() is None
    clock.now_s += 0.5
    assert liveness.expired() is CloseReason.CLIENT_GONE
