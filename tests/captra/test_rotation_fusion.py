import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.geometry import axis_angle, is_rotation, rotation_angle
from captra.rotation_fusion import ROTATION_FUSIONS, ROTATION_NET_ALONE

SEEDS = st.integers(0, 2**32 - 1)


def turn(rng: np.random.Generator, most: float = 0.6) -> np.ndarray:
    return axis_angle(rng.standard_normal(3), rng.uniform(0, most))


@given(SEEDS)
def test_rotation_net_alone_hears_nobody_else(seed: int) -> None:
    rng = np.random.default_rng(seed)
    ours, theirs = turn(rng), turn(rng)
    np.testing.assert_array_equal(ROTATION_NET_ALONE(ours, theirs), ours)


@given(SEEDS)
def test_tilt_is_kept_and_the_turn_comes_from_the_coordinates(seed: int) -> None:
    rng = np.random.default_rng(seed)
    tilt, yaw = turn(rng), axis_angle(np.array([0.0, 1, 0]), rng.uniform(-1, 1))
    fused = ROTATION_FUSIONS["turn-about-y-from-coordinates"](tilt, tilt @ yaw)
    np.testing.assert_allclose(fused, tilt @ yaw, atol=1e-9)


@given(SEEDS)
def test_fused_rotation_has_the_tilt_of_one_and_is_as_near_to_the_other_as_it_can_be(seed: int) -> None:
    rng = np.random.default_rng(seed)
    ours, theirs = turn(rng), turn(rng)
    fused = ROTATION_FUSIONS["turn-about-y-from-coordinates"](ours, theirs)
    assert is_rotation(fused, 1e-9)
    np.testing.assert_allclose(fused[:, 1], ours[:, 1], atol=1e-9)
    for step in (-0.01, 0.01):
        other = fused @ axis_angle(np.array([0.0, 1, 0]), step)
        assert rotation_angle(fused.T @ theirs) <= rotation_angle(other.T @ theirs) + 1e-9


@given(SEEDS)
def test_where_both_know_the_turn_they_meet_half_way_and_tilt_is_rotation_nets(seed: int) -> None:
    rng = np.random.default_rng(seed)
    ours, theirs = turn(rng), turn(rng)
    whole, half = (ROTATION_FUSIONS[f"turn-about-y-{name}"](ours, theirs) for name in ("from-coordinates", "half-way"))
    np.testing.assert_allclose(half[:, 1], ours[:, 1], atol=1e-9)
    np.testing.assert_allclose(half @ (ours.T @ half), whole, atol=1e-9)


@given(SEEDS)
def test_coordinates_alone_hear_nobody_else(seed: int) -> None:
    rng = np.random.default_rng(seed)
    ours, theirs = turn(rng), turn(rng)
    np.testing.assert_array_equal(ROTATION_FUSIONS["coordinates"](ours, theirs), theirs)


@given(SEEDS)
def test_the_mean_lies_half_way(seed: int) -> None:
    rng = np.random.default_rng(seed)
    ours, theirs = turn(rng), turn(rng)
    fused = ROTATION_FUSIONS["mean"](ours, theirs)
    half = rotation_angle(ours.T @ theirs) / 2
    np.testing.assert_allclose([rotation_angle(ours.T @ fused), rotation_angle(fused.T @ theirs)], half, atol=1e-6)


def test_manifests_name_what_exists() -> None:
    assert set(ROTATION_FUSIONS) == {
        "rotation-net",
        "turn-about-y-from-coordinates",
        "turn-about-y-half-way",
        "coordinates",
        "mean",
    }
    assert ROTATION_FUSIONS["rotation-net"] is ROTATION_NET_ALONE
    with pytest.raises(KeyError):
        ROTATION_FUSIONS["majority"]
