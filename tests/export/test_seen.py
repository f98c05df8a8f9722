from pathlib import Path

import numpy as np
import pytest

from captra.categories import get_category
from captra.data.generation import generate_views
from captra.data.shapes import make_shape
from captra.data.views import ViewOptions
from captra.learn.rotation_net import RotationNet
from captra.runtime.bundle import load_manifest, verify
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import REALTIME, build_neighborhoods
from export.inputs import made_up_clouds
from export.rounding import NEAREST, Compensated
from export.seen import MadeUpFor, ViewsError, to_nearest
from tests.export.test_cli import export_to, run
from tests.made_up import networks_of, write_bundle, write_checkpoints


@pytest.fixture(scope="module")
def views(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("views")
    few = ViewOptions(max_rays=30_000, points=(1_500, 2_000), least_object_points=300)
    generate_views("glasses", 4, 1, folder, lambda rng: make_shape("glasses", rng), few)
    return folder


def test_both_networks_are_made_up_for_on_what_all_their_products_see(views: Path) -> None:
    made_up_for = MadeUpFor.on(get_category("glasses"), views)
    for network in networks_of("glasses"):
        rounding = made_up_for(network)
        assert isinstance(rounding, Compensated)
        assert {"level1.0.0.weight", "level3.1.weight", "up1.coarse", "last.weight"} <= rounding.second_moments.keys()
        assert all(np.trace(moment) > 0 for moment in rounding.second_moments.values())
        assert ("heads.2.1.weight" in rounding.second_moments) == isinstance(network, RotationNet)


def test_without_views_numbers_are_the_nearest() -> None:
    assert to_nearest(networks_of("mug")[0]) is NEAREST


def test_views_of_other_objects_are_refused(views: Path, tmp_path: Path) -> None:
    with pytest.raises(ViewsError, match=r"are of 3 part\(s\), but drawers has 4: give those that it was trained on"):
        MadeUpFor.on(get_category("drawers"), views)
    bundle = write_bundle("mug", tmp_path / "mug")
    before = {path.name: path.read_bytes() for path in bundle.iterdir()}
    _, rotation = write_checkpoints("mug", tmp_path)
    status, output = run("replace-network", "--rotation", rotation, "--bundle", bundle, "--views", views)
    assert status == 1
    assert "are of 3 part(s), but mug has 1" in output.replace("\n", " ")
    assert {path.name: path.read_bytes() for path in bundle.iterdir()} == before


def test_a_folder_without_views_is_answered_with_how_to_make_some(tmp_path: Path) -> None:
    with pytest.raises(ViewsError, match="captra generate --category mug --count 200"):
        MadeUpFor.on(get_category("mug"), tmp_path)


def test_a_bundle_whose_rounding_was_made_up_for_answers_nearer_to_its_checkpoints(views: Path, tmp_path: Path) -> None:
    checkpoints = write_checkpoints("glasses", tmp_path)
    for name, more in (("exact", ["float32"]), ("made-up-for", ["int4", "--views", views]), ("nearest", ["int4"])):
        status, output = export_to(tmp_path / name, checkpoints, "glasses", "--precision", *more)
        assert status == 0, output
        verify(tmp_path / name, load_manifest(tmp_path / name))
    exact, *others = (coordinates_of(tmp_path / name) for name in ("exact", "made-up-for", "nearest"))
    near, far = (np.sqrt(np.square(other - exact).mean()) for other in others)
    assert 0 < near < 0.8 * far


def coordinates_of(bundle: Path) -> np.ndarray:
    networks = OnnxNetworks.load(bundle, REALTIME, "cpu", threads=1)
    cloud = made_up_clouds(1, REALTIME, 1)[0]
    return networks.coordinates(cloud, build_neighborhoods(cloud, REALTIME))[1]
