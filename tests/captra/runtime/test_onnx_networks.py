import shutil
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
import onnxruntime
import pytest

from captra.categories import UnknownCategoryError, get_category
from captra.geometry import Pose, rotation_angle
from captra.learn.networks import TorchNetworks
from captra.mirrors import ACROSS
from captra.runtime.bundle import BundleError, Manifest, load_manifest, write_manifest
from captra.runtime.onnx_networks import OnnxNetworks, runs_at_a_time
from captra.runtime.providers import OPENVINO
from captra.sampling import PAPER, REALTIME, build_neighborhoods
from captra.shipped import MODELS
from captra.tracker import Tracker
from export.inputs import made_up_clouds
from export.parity import compare
from tests.made_up import networks_of, write_bundle


def test_a_tracker_runs_on_a_bundle(mug_bundle: Path) -> None:
    networks = OnnxNetworks.load(mug_bundle, REALTIME, "cpu")
    pose = Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), np.full((1, 3), 0.1))
    cloud = np.random.default_rng(0).uniform(-0.06, 0.06, (2000, 3)).astype(np.float32)
    result = Tracker(networks, pose).step(cloud)
    assert np.isfinite(result.pose.translation).all()
    assert networks.category.name == "mug"
    assert networks.input_sampling == load_manifest(mug_bundle).input_sampling


def test_shapes_of_many_parts(tmp_path: Path) -> None:
    networks = OnnxNetworks.load(write_bundle("drawers", tmp_path / "drawers"), REALTIME, "cpu", threads=1)
    clouds = made_up_clouds(4, REALTIME)
    neighborhoods = [build_neighborhoods(cloud, REALTIME) for cloud in clouds]
    segmentation, coordinates = networks.coordinates(clouds[3], neighborhoods[3])
    assert segmentation.shape == (4, 1024)
    np.testing.assert_allclose(segmentation.sum(axis=0), 1, atol=1e-5)
    assert coordinates.shape == (4, 1024, 3)
    assert np.abs(coordinates).max() <= 0.5
    assert networks.rotations(clouds, neighborhoods).shape == (4, 1024, 6)


def test_left_and_right_are_one_in_a_bundle_that_asks_in_the_mirror_too() -> None:
    networks = OnnxNetworks.load(MODELS / "glasses", REALTIME, "cpu", threads=1)
    (cloud,) = made_up_clouds(1, REALTIME)
    neighborhoods = build_neighborhoods(cloud, REALTIME)
    segmentation, coordinates = networks.coordinates(cloud, neighborhoods)
    segmentation_mirrored, coordinates_mirrored = networks.coordinates(cloud * ACROSS, neighborhoods)
    np.testing.assert_allclose(segmentation_mirrored[[1, 0, 2]], segmentation, atol=1e-5)
    np.testing.assert_allclose(coordinates_mirrored[[1, 0, 2]] * ACROSS, coordinates, atol=1e-5)
    once = replace(networks, manifest=replace(networks.manifest, mirror="none"))
    assert np.abs(once.coordinates(cloud, neighborhoods)[1] - coordinates).max() > 0.001


def test_threads_share_the_networks(mug_bundle: Path) -> None:
    networks = OnnxNetworks.load(mug_bundle, REALTIME, "cpu", threads=1)
    inputs = []
    for seed in range(4):
        (cloud,) = made_up_clouds(1, REALTIME, seed)
        inputs.append((cloud, build_neighborhoods(cloud, REALTIME)))

    def run(index: int) -> list[np.ndarray]:
        cloud, neighborhoods = inputs[index % len(inputs)]
        return [*networks.coordinates(cloud, neighborhoods), networks.rotations(cloud[None], [neighborhoods])]

    alone = [run(index) for index in range(len(inputs))]
    with ThreadPoolExecutor(4) as pool:
        for index, together in enumerate(pool.map(run, range(12))):
            for one, other in zip(alone[index % len(inputs)], together, strict=True):
                np.testing.assert_array_equal(one, other)


def test_a_cloud_of_another_profile_is_refused(mug_bundle: Path) -> None:
    networks = OnnxNetworks.load(mug_bundle, PAPER, "cpu", threads=1)
    (cloud,) = made_up_clouds(1, REALTIME)
    with pytest.raises(Exception, match="1024"):
        networks.coordinates(cloud, build_neighborhoods(cloud, REALTIME))


def test_a_damaged_bundle_is_not_loaded(mug_bundle: Path, tmp_path: Path) -> None:
    copy = shutil.copytree(mug_bundle, tmp_path / "mug")
    content = bytearray((copy / "rotation.onnx").read_bytes())
    content[len(content) // 2] ^= 1
    (copy / "rotation.onnx").write_bytes(content)
    with pytest.raises(BundleError, match=r"rotation\.onnx is damaged"):
        OnnxNetworks.load(copy, REALTIME, "cpu")


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        (lambda m: replace(m, parts=("handle", "body")), BundleError, "has the parts handle, body, but mug has mug"),
        (lambda m: replace(m, category="teapot"), UnknownCategoryError, "teapot"),
    ],
)
def test_a_bundle_of_something_else(
    change: Callable[[Manifest], Manifest], error: type[Exception], message: str, mug_bundle: Path, tmp_path: Path
) -> None:
    copy = shutil.copytree(mug_bundle, tmp_path / "mug")
    write_manifest(copy, change(load_manifest(copy)))
    with pytest.raises(error, match=message):
        OnnxNetworks.load(copy, REALTIME, "cpu")


@pytest.mark.parametrize("provider", ["cpu", "openvino"])
def test_both_providers_track_alike(provider: str, mug_bundle: Path) -> None:
    """However fast: a whole step lands where the reference does, one thread and CPU provider."""
    if provider == "openvino" and OPENVINO not in onnxruntime.get_available_providers():
        pytest.skip("this build of onnxruntime has no OpenVINO")
    pose = Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), np.full((1, 3), 0.1))
    cloud = np.random.default_rng(0).uniform(-0.06, 0.06, (2000, 3)).astype(np.float32)
    reference, fast = (
        Tracker(OnnxNetworks.load(mug_bundle, REALTIME, name, threads), pose).step(cloud).pose
        for name, threads in (("cpu", 1), (provider, 2))
    )
    assert np.degrees(rotation_angle(reference.rotation[0].T @ fast.rotation[0])) < 3
    np.testing.assert_allclose(fast.translation, reference.translation, atol=0.005)
    np.testing.assert_allclose(fast.scale, reference.scale, rtol=0.02)


@pytest.mark.parametrize(("threads", "parts", "runs"), [(1, 1, 1), (2, 1, 2), (8, 1, 2), (2, 4, 1)])
def test_two_networks_share_the_threads(threads: int, parts: int, runs: int) -> None:
    assert runs_at_a_time(threads, parts) == runs


@pytest.mark.skipif(
    OPENVINO not in onnxruntime.get_available_providers(), reason="this build of onnxruntime has no OpenVINO"
)
def test_openvino_agrees_within_its_precision(mug_bundle: Path) -> None:
    networks = OnnxNetworks.load(mug_bundle, REALTIME, "openvino")
    difference = compare(TorchNetworks(get_category("mug"), REALTIME, *networks_of("mug")), networks)
    assert networks.provider.name == "openvino"
    assert difference.segmentation < 0.05
    assert difference.coordinates < 0.05
    assert difference.mean_rotation_deg < 3
