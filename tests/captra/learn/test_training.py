import copy
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from captra.categories import get_category
from captra.data.view import View
from captra.learn.checkpoint import CheckpointError, load_coordinate_net, load_rotation_net, training_info
from captra.learn.curves import plot_curves
from captra.learn.plan import COORDINATE, ROTATION, Plan, Stage
from captra.learn.training import LOG_FILE, STATE_FILE, PoorViewsError, Progress, Trainer
from captra.sampling import Profile
from tests.made_up import batch_of_clouds, networks_of, write_bundle
from tests.oracle import scene

TINY = Profile("tiny", 128, (32, 8), ((4, 4, 4), (4, 4)))
PLAN = Plan(samples=24, batch_size=4, head_start=0.5, stages=(Stage(1.0, (TINY,)),))


class FewViews:
    """Two views of one box, kept in memory."""

    def __init__(self, name: str) -> None:
        rng = np.random.default_rng(0)
        category, truth, cloud = scene(name, rng, count=600)
        labels = np.repeat(np.arange(category.num_classes), [600] * category.num_parts + [150] * category.background)
        self.view = View(
            points=cloud,
            labels=labels.astype(np.uint8),
            rotation=truth.rotation.astype(np.float32),
            translation=truth.translation.astype(np.float32),
            size=truth.size.astype(np.float32),
            joint_values=np.zeros(0, np.float32),
        )

    def __len__(self) -> int:
        return 2

    def __getitem__(self, index: int) -> View:
        return self.view

    def refresh(self) -> int:
        return 2


def train(folder: Path, plan: Plan = PLAN, name: str = "mug", stop_after: int | None = None) -> list[int]:
    seen: list[int] = []

    def report(progress: Progress, terms: dict[str, float]) -> None:
        seen.append(progress.samples)
        assert all(np.isfinite(value) for value in terms.values())
        if stop_after is not None and len(seen) == stop_after:
            raise KeyboardInterrupt

    trainer = Trainer(get_category(name), FewViews(name), plan, folder)
    try:
        trainer.run(report)
    except KeyboardInterrupt:
        assert stop_after is not None
    return seen


@pytest.mark.parametrize("name", ["mug", "bottle", "laptop_articulated"])
def test_both_networks_train_and_leave_checkpoints(tmp_path: Path, name: str) -> None:
    assert train(tmp_path, name=name) == [4, 8, 12, 16, 20, 24]
    rows = [json.loads(line) for line in (tmp_path / LOG_FILE).read_text().splitlines()]
    assert [("rotation/rotation" in row) for row in rows] == [False] * 3 + [True] * 3
    category = get_category(name)
    assert not load_coordinate_net(tmp_path / "coordinate.pt", category).training
    assert not load_rotation_net(tmp_path / "rotation.pt", category).training
    info = training_info(tmp_path / "coordinate.pt")
    assert (info["samples"], info["batch_size"]) == (24, 4)


def test_an_interrupted_run_goes_on_where_it_stopped(tmp_path: Path) -> None:
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    train(whole)
    assert train(parts, stop_after=2) == [4, 8]
    assert train(parts) == [12, 16, 20, 24]
    ours, theirs = (torch.load(folder / "state.pt", weights_only=True) for folder in (parts, whole))
    for name, tensor in theirs["coordinate"]["network"].items():
        torch.testing.assert_close(ours["coordinate"]["network"][name], tensor, msg=name)


def test_a_finished_run_has_nothing_left_to_do(tmp_path: Path) -> None:
    train(tmp_path)
    assert train(tmp_path) == []


def test_views_that_show_too_little_end_a_run_with_advice(tmp_path: Path) -> None:
    with pytest.raises(PoorViewsError, match="fewer than 9999 points of the object: generate others"):
        train(tmp_path, replace(PLAN, least_object_points=9_999))


def test_a_new_run_can_start_from_the_weights_of_another(tmp_path: Path) -> None:
    train(tmp_path / "old")
    trainer = Trainer(get_category("mug"), FewViews("mug"), replace(PLAN, seed=2), tmp_path / "new")
    trainer.start_from(get_category("mug"), tmp_path / "old")
    old = load_coordinate_net(tmp_path / "old" / "coordinate.pt", get_category("mug"))
    for name, tensor in old.state_dict().items():
        torch.testing.assert_close(trainer.coordinate.network.state_dict()[name], tensor)
    assert trainer.progress.rotation_started


def test_a_new_run_can_start_from_a_bundle(tmp_path: Path) -> None:
    mug = get_category("mug")
    bundle = write_bundle("mug", tmp_path / "mug")
    trainer = Trainer(mug, FewViews("mug"), PLAN, tmp_path / "run")
    trainer.start_from(mug, bundle)
    for network in (trainer.coordinate, trainer.rotation):
        assert network.network.training
        torch.testing.assert_close(network.averaged.state_dict(), network.network.state_dict())
    points, neighborhoods = batch_of_clouds(2, 0)
    with torch.no_grad():
        ours = trainer.coordinate.averaged.eval()(points, neighborhoods)
        theirs = networks_of("mug")[0](points, neighborhoods)
    torch.testing.assert_close(ours, theirs, rtol=0.05, atol=0.02)


def test_a_new_run_can_start_from_another_category(tmp_path: Path) -> None:
    train(tmp_path / "mug")
    glasses = get_category("glasses")
    trainer = Trainer(glasses, FewViews("glasses"), PLAN, tmp_path / "glasses")
    trainer.start_from(get_category("mug"), tmp_path / "mug")
    coordinate = load_coordinate_net(tmp_path / "mug" / "coordinate.pt", get_category("mug"))
    rotation = load_rotation_net(tmp_path / "mug" / "rotation.pt", get_category("mug"))
    torch.testing.assert_close(trainer.coordinate.network.hidden.weight, coordinate.hidden.weight)
    for head in trainer.rotation.network.heads:
        torch.testing.assert_close(head.state_dict(), rotation.heads[0].state_dict())
    assert trainer.coordinate.network.coordinates.out_features == 9


def test_rotation_net_can_be_trained_anew_beside_a_coordinate_net_that_stays(tmp_path: Path) -> None:
    train(tmp_path / "mug")
    mug = get_category("mug")
    trainer = Trainer(mug, FewViews("mug"), replace(PLAN, networks=(ROTATION,), anew=True), tmp_path / "anew")
    head, last = "heads.0.layers.0.weight", "backbone.last.weight"
    trainer.start_from(mug, tmp_path / "mug")
    before, started = (copy.deepcopy(one.network.state_dict()) for one in (trainer.coordinate, trainer.rotation))
    torch.testing.assert_close(started[last], before[last])
    assert not torch.equal(started[head], load_rotation_net(tmp_path / "mug" / "rotation.pt", mug).state_dict()[head])
    terms: list[dict[str, float]] = []
    trainer.run(lambda _, of_step: terms.append(of_step))
    torch.testing.assert_close(trainer.coordinate.network.state_dict(), before)
    assert not torch.equal(
        trainer.rotation.network.state_dict()["backbone.last.weight"], started["backbone.last.weight"]
    )
    assert all(name.startswith("rotation/") for of_step in terms for name in of_step)


def test_coordinate_net_can_be_trained_on_beside_a_rotation_net_that_stays(tmp_path: Path) -> None:
    train(tmp_path / "mug")
    mug = get_category("mug")
    trainer = Trainer(mug, FewViews("mug"), replace(PLAN, networks=(COORDINATE,)), tmp_path / "further")
    trainer.start_from(mug, tmp_path / "mug")
    last = "backbone.last.weight"
    before, started = (copy.deepcopy(one.network.state_dict()) for one in (trainer.rotation, trainer.coordinate))
    torch.testing.assert_close(started, dict(load_coordinate_net(tmp_path / "mug" / "coordinate.pt", mug).state_dict()))
    terms: list[dict[str, float]] = []
    trainer.run(lambda _, of_step: terms.append(of_step))
    torch.testing.assert_close(trainer.rotation.network.state_dict(), before)
    assert not torch.equal(trainer.coordinate.network.state_dict()[last], started[last])
    assert not any(name.startswith("rotation/") for of_step in terms for name in of_step)


def test_rotation_net_can_be_trained_on_from_its_own_weights(tmp_path: Path) -> None:
    train(tmp_path / "mug")
    mug = get_category("mug")
    trainer = Trainer(mug, FewViews("mug"), replace(PLAN, networks=(ROTATION,)), tmp_path / "further")
    trainer.start_from(mug, tmp_path / "mug")
    started = copy.deepcopy(trainer.rotation.network.state_dict())
    torch.testing.assert_close(started, dict(load_rotation_net(tmp_path / "mug" / "rotation.pt", mug).state_dict()))
    before = copy.deepcopy(trainer.coordinate.network.state_dict())
    trainer.run(lambda _, of_step: None)
    torch.testing.assert_close(trainer.coordinate.network.state_dict(), before)
    head = "heads.0.layers.0.weight"
    assert not torch.equal(trainer.rotation.network.state_dict()[head], started[head])


def test_learning_rate_halves_evenly_and_stages_follow_each_other() -> None:
    plan = Plan(samples=1000, halvings=4)
    assert plan.learning_rate_at(500) == pytest.approx(plan.learning_rate / 4)
    assert plan.learning_rate_at(2000) == plan.learning_rate_at(1000)
    assert [len(plan.stage_at(n).profiles) for n in (0, 599, 600, 959, 960, 1000)] == [1, 1, 2, 2, 3, 3]


def test_curves_are_drawn_from_a_long_enough_log(tmp_path: Path) -> None:
    log = tmp_path / "log.jsonl"
    log.write_text("".join(json.dumps({"samples": n, "coordinates": 1 / n}) + "\n" for n in range(1, 50)))
    plot_curves(log, tmp_path / "short.png")
    assert not (tmp_path / "short.png").exists()
    log.write_text(log.read_text() * 5)
    plot_curves(log, tmp_path / "curves.png")
    assert (tmp_path / "curves.png").stat().st_size > 1000


def test_the_state_of_an_earlier_version_is_refused_with_a_way_out(tmp_path: Path) -> None:
    train(tmp_path, stop_after=1)
    state = torch.load(tmp_path / STATE_FILE, weights_only=True)
    state["coordinate"]["optimizer"] = state["coordinate"].pop("optimizers")[1]
    torch.save(state, tmp_path / STATE_FILE)
    with pytest.raises(CheckpointError, match="--run"):
        train(tmp_path)
