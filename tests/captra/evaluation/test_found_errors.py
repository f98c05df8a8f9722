from dataclasses import dataclass, field, replace

import numpy as np
import pytest

from captra.categories import get_category
from captra.evaluation.found_errors import LARGEST_ROTATION_DEG, describe, measure_found_error
from captra.evaluation.sequences import Sequence
from captra.evaluation.workers import Here
from captra.geometry import axis_angle
from captra.looking import Networks
from captra.pose_memory import USUAL_ERROR, FoundError
from tests.captra.evaluation.test_evaluation import Held, still_recording
from tests.oracle import OracleNetworks


@dataclass(frozen=True, eq=False)
class Biased:
    """Networks that are off by something else for each object that they meet, and by noise in each frame."""

    category: str
    turns_deg: tuple[float, ...]
    """About y, object by object."""
    noise_deg: float = 0.0
    met: list[float] = field(default_factory=list)

    def load(self) -> Networks:
        """Networks for the next object."""
        recording = still_recording(self.category)
        turn_deg, noise, rng = self.turns_deg[len(self.met)], self.noise_deg, np.random.default_rng(len(self.met))
        self.met.append(turn_deg)

        class Off(OracleNetworks):
            def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
                off_deg = turn_deg + noise * rng.choice([-1, 1])
                off = axis_angle(np.array([0.0, 1.0, 0.0]), np.radians(off_deg))
                self.truth = replace(recording.truth(0), rotation=recording.truth(0).rotation @ off)
                return super().coordinates(points_canonical, neighborhoods)

        return Off(recording.category, recording.truth(0), recording.truth(0))


@pytest.fixture(autouse=True)
def every_object_has_networks_of_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("captra.evaluation.found_errors.loaded", lambda networks: networks.load())


def measured(category: str, turns_deg: tuple[float, ...], noise_deg: float = 0.0, frames: int = 6) -> FoundError:
    held = [Held(Sequence(still_recording(category, frames), ())) for _ in turns_deg]
    return measure_found_error(get_category(category), Biased(category, turns_deg, noise_deg), held, Here())


def test_what_stays_wrong_is_measured_about_its_axis() -> None:
    ((x, y, z),) = measured("camera", (3.0, -3.0, 4.0, -4.0)).rotation_deg
    assert y == pytest.approx(np.sqrt(12.5), abs=0.2)
    assert max(x, z) < 0.2


def test_what_comes_and_goes_is_not() -> None:
    calm, noisy = (measured("camera", (0.0,) * 12, noise, frames=40).rotation_deg[0][1] for noise in (0.0, 4.0))
    assert calm < 0.1
    assert noisy < 1.5


class Larger(OracleNetworks):
    """Networks to which every object seems longer, and all its other sides shorter."""

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        labels, coordinates = super().coordinates(points_canonical, neighborhoods)
        return labels, coordinates * np.array([1.0, 1.0, 1.2], np.float32) / np.float32(1.2)


def test_what_networks_make_of_the_size_is_measured_whatever_was_given(monkeypatch: pytest.MonkeyPatch) -> None:
    recording = still_recording("camera", 4)
    larger = Larger(recording.category, recording.truth(0), recording.truth(0))
    monkeypatch.setattr("captra.evaluation.found_errors.loaded", lambda _: larger)
    held = [Held(Sequence(recording, ()))] * 2
    error = measure_found_error(recording.category, Biased("camera", ()), held, Here())
    ((scale,),), ((x, y, z),) = error.scale, error.side
    aspect = recording.size[0] / np.linalg.norm(recording.size[0])
    assert 0.02 < scale < 0.18
    assert z == pytest.approx(aspect[2] * (np.exp(scale) - 1), rel=0.1)
    expected = aspect[:2] * (1 - np.exp(scale) / 1.2)
    np.testing.assert_allclose((x, y), np.maximum(expected, USUAL_ERROR.side[0][0]), rtol=0.1)


def test_sizes_are_never_taken_to_be_told_better_than_usual() -> None:
    error = measured("camera", (1.0, -1.0))
    assert (error.scale, error.side) == (USUAL_ERROR.scale, USUAL_ERROR.side)


def test_lost_tracks_count_as_little_as_the_worst_ones_that_hold() -> None:
    assert measured("camera", (40.0, -40.0)).rotation_deg[0][1] <= LARGEST_ROTATION_DEG


def test_an_object_that_looks_the_same_all_round_has_no_error_about_its_axis_and_like_ones_across_it() -> None:
    error = measured("bottle", (5.0, -5.0))
    assert error.rotation_deg[0][1] < 0.1
    for x, _, z in (error.rotation_deg[0], error.centre[0], error.side[0]):
        assert x == z


def test_it_fits_into_a_manifest() -> None:
    error = measured("scissors", (2.0, -2.0))
    assert FoundError.measured(error.calibration) == error
    assert len(error.centre) == len(error.rotation_deg) == len(error.scale) == len(error.side) == 2
    assert "% of the scale" in describe(error)
