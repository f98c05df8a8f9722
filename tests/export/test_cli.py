import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import typer
from typer.testing import CliRunner

from captra.runtime.bundle import COORDINATE, ROTATION, MeshCredit, Score, load_manifest, verify, write_manifest
from captra.sampling import InputSampling
from export.cli import export, replace_network, step
from tests import reference
from tests.made_up import write_bundle, write_checkpoints

APP = typer.Typer()
APP.command("export")(export)
APP.command("replace-network")(replace_network)
APP.command("step")(step)


def run(*arguments: object) -> tuple[int, str]:
    result = CliRunner().invoke(APP, [str(argument) for argument in arguments])
    return result.exit_code, result.output


def export_to(out: Path, checkpoints: tuple[Path, Path], category: str, *more: object) -> tuple[int, str]:
    coordinate, rotation = checkpoints
    return run(
        "export", "--coordinate", coordinate, "--rotation", rotation, "--category", category, "--out", out, *more
    )


@reference.needs_reference
@pytest.mark.parametrize("category", reference.CATEGORIES)
def test_the_authors_checkpoints_become_a_bundle_that_steps_like_them(category: str, tmp_path: Path) -> None:
    checkpoints = reference.write_checkpoints(category, tmp_path)
    status, output = export_to(tmp_path / "bundle", checkpoints, category, "--precision", "float32")
    assert status == 0, output
    assert "paper: differs" in output
    assert "realtime: differs" in output
    source = reference.REFERENCE / f"step_{category}.npz"
    status, output = run("step", tmp_path / "bundle", source, tmp_path / "out.npz")
    assert status == 0, output
    with np.load(tmp_path / "out.npz") as stored:
        answers = dict(stored)
    expected = reference.step_of(category)
    reference.assert_matches_reference(answers, expected)
    parts = len(expected["last_scale"])
    shapes = {name: answers[name].shape for name in answers}
    assert shapes == {
        "seg": expected["seg"].shape,
        "coords": expected["coords"].shape,
        "labels": expected["labels"].shape,
        "delta_point_rotation": (parts, 4096, 3, 3),
        "rotation": (parts, 3, 3),
        "scale": (parts,),
        "translation": (parts, 3),
    }
    manifest = load_manifest(tmp_path / "bundle")
    assert manifest.training.data.startswith("the authors' released checkpoints")
    assert manifest.rotation_input == "crop"
    assert manifest.input_sampling == InputSampling()


def test_our_checkpoints_become_a_bundle(tmp_path: Path) -> None:
    training: dict[str, object] = {
        "samples": 1200,
        "seed": 3,
        "commit": "abc123",
        "data": "made-up mugs",
        "input_sampling": {"surroundings_weight": 0.4, "margin": 0.1},
        "meshes": [{"name": "cup", "license": "CC-BY-4.0", "attribution": "A. Nother"}],
    }
    notes = tmp_path / "notes.json"
    notes.write_text(json.dumps({"scores": [{"command": "captra evaluate", "values": {"5°5cm %": 90.0}}]}))
    out = tmp_path / "models" / "mug"
    status, output = export_to(out, write_checkpoints("mug", tmp_path, training), "mug", "--notes", notes)
    assert status == 0, output
    manifest = load_manifest(out)
    verify(out, manifest)
    assert sorted(path.name for path in out.iterdir()) == ["coordinate.onnx", "manifest.json", "rotation.onnx"]
    assert [path.name for path in out.parent.iterdir()] == ["mug"]
    assert (manifest.precision, manifest.category, manifest.parts) == ("float16", "mug", ("mug",))
    assert (manifest.training.steps, manifest.training.seed, manifest.training.commit) == (100, 3, "abc123")
    assert manifest.training.meshes[0].attribution == "A. Nother"
    assert manifest.input_sampling.surroundings_weight == 0.4
    assert manifest.scores[0].values == {"5°5cm %": 90.0}


def test_exporting_again_replaces_the_bundle(tmp_path: Path) -> None:
    out = write_bundle("mug", tmp_path / "mug", "float32")
    status, _ = export_to(out, write_checkpoints("mug", tmp_path), "mug")
    assert status == 0
    verify(out, load_manifest(out))
    assert load_manifest(out).precision == "float16"


def test_another_rotation_net_leaves_the_rest_and_takes_away_what_was_measured(tmp_path: Path) -> None:
    bundle = write_bundle("mug", tmp_path / "mug")
    before = replace(
        load_manifest(bundle),
        rotation_fusion="mean",
        mirror="left-and-right",
        scores=(Score("captra evaluate", {"5°5cm %": 90.0}),),
        health={"doubt_below": 0.1},
        found_error={"rotation_deg": [[1.0, 1.0, 1.0]]},
    )
    write_manifest(bundle, before)
    coordinate = (bundle / COORDINATE).read_bytes()
    cup = {"name": "cup", "license": "CC0", "attribution": "A. Nother"}
    write_manifest(bundle, replace(before, training=replace(before.training, meshes=(MeshCredit("cup", "CC0", "?"),))))
    info: dict[str, object] = {"samples": 77, "seed": 5, "meshes": [cup]}
    _, rotation = write_checkpoints("mug", tmp_path, info)
    status, output = run("replace-network", "--rotation", rotation, "--bundle", bundle)
    assert status == 0, output
    assert "next: captra fuse --category mug" in output
    after = load_manifest(bundle)
    verify(bundle, after)
    assert (bundle / COORDINATE).read_bytes() == coordinate
    assert (bundle / ROTATION).stat().st_size < len(coordinate), "a larger network in half the room"
    assert (after.precision, after.rotation_fusion, after.mirror) == ("float16 and int8", "mean", "left-and-right")
    assert (after.scores, after.health, after.found_error) == ((), {}, {})
    assert after.training.details["rotation"] == {"samples": 77, "seed": 5}
    assert after.training.meshes == (MeshCredit(**cup),), "who made it is known by now"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["coordinate.pt", "mug", "rotation.pt"]


def test_another_coordinate_net_leaves_rotation_net_as_it_is(tmp_path: Path) -> None:
    bundle = write_bundle("mug", tmp_path / "mug")
    rotation = (bundle / ROTATION).read_bytes()
    info: dict[str, object] = {"samples": 99, "input_sampling": {"surroundings_weight": 0.25, "margin": 0.2}}
    coordinate, other = write_checkpoints("mug", tmp_path, info)
    status, output = run("replace-network", "--coordinate", coordinate, "--bundle", bundle)
    assert status == 0, output
    after = load_manifest(bundle)
    verify(bundle, after)
    assert (bundle / ROTATION).read_bytes() == rotation
    assert after.training.details["coordinate"] == {"samples": 99}
    assert after.input_sampling == InputSampling(surroundings_weight=0.25, margin=0.2)
    assert after.precision == "int8 and float16"
    for name, checkpoint, both in (("rotation", other, "int8 and int5"), ("coordinate", coordinate, "int5")):
        status, output = run("replace-network", f"--{name}", checkpoint, "--bundle", bundle, "--precision", "int5")
        assert status == 0, output
        assert load_manifest(bundle).precision == both


@pytest.mark.parametrize("given", [[], ["--coordinate", "--rotation"]])
def test_one_network_is_replaced_at_a_time(given: list[str], tmp_path: Path) -> None:
    bundle = write_bundle("mug", tmp_path / "mug")
    files = dict(zip(("--coordinate", "--rotation"), write_checkpoints("mug", tmp_path), strict=True))
    status, output = run(
        "replace-network", "--bundle", bundle, *(part for name in given for part in (name, files[name]))
    )
    assert status == 2
    assert "either --coordinate FILE or --rotation FILE" in output


def test_a_rotation_net_of_another_category_changes_nothing(tmp_path: Path) -> None:
    bundle = write_bundle("bottle", tmp_path / "bottle")
    before = {path.name: path.read_bytes() for path in bundle.iterdir()}
    _, rotation = write_checkpoints("mug", tmp_path)
    status, output = run("replace-network", "--rotation", rotation, "--bundle", bundle)
    assert status == 1
    assert "is not the RotationNet of bottle" in output
    assert {path.name: path.read_bytes() for path in bundle.iterdir()} == before


@pytest.mark.parametrize(
    ("category", "more", "message"),
    [
        ("bottle", [], "is not the RotationNet of bottle"),
        ("teapot", [], "unknown category 'teapot'"),
        ("mug", ["--precision", "int2"], "unknown precision 'int2'"),
    ],
)
def test_errors_say_what_to_do_and_leave_nothing_behind(
    category: str, more: list[str], message: str, tmp_path: Path
) -> None:
    status, output = export_to(tmp_path / "models" / "out", write_checkpoints("mug", tmp_path), category, *more)
    assert status == 1
    assert message in output
    assert "Traceback" not in output
    assert not list((tmp_path / "models").glob("*"))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"last_scale": None}, "the input lacks last_scale"),
        ({"last_scale": np.ones(2)}, "last_scale has shape (2,): the bundle's 1 part(s) need (1,)"),
        ({"points": np.zeros((100, 3))}, "at least 512 rows"),
        ({"points": np.full((4096, 3), np.nan)}, "points holds NaN, infinity or no numbers"),
        ({"last_translation": np.full((1, 3), np.inf)}, "last_translation holds NaN, infinity or no numbers"),
        ({"last_scale": np.array(["a"])}, "last_scale holds NaN, infinity or no numbers"),
        ({"last_scale": np.zeros(1)}, "last_scale is [0.0]: give the diagonals"),
    ],
)
def test_a_step_from_incomplete_arrays(change: dict[str, np.ndarray | None], message: str, tmp_path: Path) -> None:
    arrays: dict[str, np.ndarray | None] = {
        "points": np.zeros((4096, 3)),
        "last_scale": np.ones(1),
        "last_rotation": np.eye(3)[None],
        "last_translation": np.zeros((1, 3)),
    }
    kept = {name: value for name, value in {**arrays, **change}.items() if value is not None}
    np.savez(tmp_path / "in.npz", allow_pickle=False, **kept)
    status, output = run("step", write_bundle("mug", tmp_path / "mug"), tmp_path / "in.npz", tmp_path / "out.npz")
    assert status == 1
    assert message in output.replace("\n", " ")
    assert not (tmp_path / "out.npz").exists()


@pytest.mark.parametrize("content", ["truncated", "array", "text", "empty"])
def test_a_step_from_another_file(content: str, tmp_path: Path) -> None:
    source, array, archive = (tmp_path / name for name in ("in.npz", "in.npy", "whole.npz"))
    np.save(array, np.zeros((4096, 3)))
    np.savez(archive, points=np.zeros((4096, 3)))
    contents = {
        "truncated": archive.read_bytes()[:1000], "array": array.read_bytes(), "text": b"points", "empty": b"",
    }  # fmt: skip
    source.write_bytes(contents[content])
    status, output = run("step", write_bundle("mug", tmp_path / "mug"), source, tmp_path / "out.npz")
    assert status == 1
    assert f"Error: {source} is no .npz archive, or damaged" in output.replace("\n", "")
    assert not (tmp_path / "out.npz").exists()


@pytest.mark.parametrize("command", ["export", "step"])
def test_help_has_an_example(command: str) -> None:
    status, output = run(command, "--help")
    assert status == 0
    assert f"captra {command} " in output
