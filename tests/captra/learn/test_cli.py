from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from captra.categories import get_category
from captra.data.generation import generate_views
from captra.data.shapes import make_shape
from captra.data.views import ViewOptions
from captra.learn.cli import NoViewsError, UnlikeError, check_alike, train
from tests.made_up import write_bundle

APP = typer.Typer(pretty_exceptions_enable=False)
APP.command()(train)


def run(*arguments: object) -> tuple[int, str]:
    result = CliRunner().invoke(APP, [str(argument) for argument in arguments], catch_exceptions=False)
    return result.exit_code, result.output


def fill(folder: Path, name: str) -> None:
    few = ViewOptions(max_rays=30_000, points=(1_500, 2_000), least_object_points=300)
    generate_views(name, 2, 1, folder / "views" / name / "train", lambda rng: make_shape(name, rng), few)


@pytest.mark.parametrize(
    ("one", "other"), [("bottle", "mug"), ("glasses", "drawers"), ("laptop", "laptop_articulated")]
)
def test_networks_are_shared_by_the_like_alone(one: str, other: str) -> None:
    check_alike(get_category("bottle"), [get_category("can"), get_category("bowl")])
    with pytest.raises(UnlikeError, match=f"{other} cannot share networks with {one}"):
        check_alike(get_category(one), [get_category(other)])


def test_a_network_shared_with_another_category_needs_its_views_too(tmp_path: Path) -> None:
    fill(tmp_path, "bottle")
    with pytest.raises(NoViewsError, match="captra generate --category can"):
        run("--category", "bottle", "--folder", tmp_path, "--shared-with", "can")


def test_one_network_alone_has_to_start_from_something(tmp_path: Path) -> None:
    fill(tmp_path, "bottle")
    status, output = run("--category", "bottle", "--folder", tmp_path, "--only", "rotation")
    assert status == 2
    assert "--start-from models/NAME" in output


def test_rotation_net_alone_starts_anew(tmp_path: Path) -> None:
    fill(tmp_path, "bottle")
    bundle = write_bundle("bottle", tmp_path / "bottle")
    status, output = run("--category", "bottle", "--folder", tmp_path, "--start-from", bundle, "--anew")
    assert status == 2
    assert "say --only rotation as well" in output


@pytest.mark.parametrize(
    "option",
    [
        ("--only", "rotation"),
        ("--anew",),
        ("--shared-with", "can"),
        ("--start-from", "models/mug"),
        ("--learning-rate", "1e-4"),
    ],
    ids=lambda option: option[0],
)
def test_a_campaign_is_not_told_what_it_plans_by_itself(option: tuple[str, ...], tmp_path: Path) -> None:
    status, output = run("--all", "--folder", tmp_path / "campaign", *option)
    assert status == 2
    assert option[0] in output
    assert not (tmp_path / "campaign").exists()


def test_a_finished_run_of_a_shared_network_leaves_its_checkpoints(tmp_path: Path) -> None:
    fill(tmp_path, "bottle")
    fill(tmp_path, "can")
    bundle = write_bundle("bottle", tmp_path / "bottle")
    shared = ["--only", "rotation", "--shared-with", "can", "--start-from", bundle]
    status, output = run("--category", "bottle", "--folder", tmp_path, "--samples", 1, *shared)
    assert status == 0, output
    assert (tmp_path / "runs" / "bottle" / "run" / "rotation.pt").exists()
