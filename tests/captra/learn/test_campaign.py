import json
from dataclasses import dataclass, field
from pathlib import Path

import pytest
import torch

from captra.categories import CATEGORIES
from captra.learn.campaign import (
    BOTH,
    COURSE,
    QUEUE,
    ROTATION_ANEW,
    WARM_STARTS,
    Campaign,
    Folders,
    LocalSteps,
    Stretch,
    load_standings,
    replace_bundle,
)


@dataclass
class Scripted:
    """Steps whose validation scores are given."""

    folders: Folders
    scores: list[float]
    done: list[str] = field(default_factory=list)
    stop_at: int = 10**9

    def make_views(self, category: str) -> None:
        self.done.append(f"views {category}")

    def train(self, category: str, stretch: Stretch, until: int) -> None:
        if until >= self.stop_at:
            raise KeyboardInterrupt
        self.done.append(f"{stretch.run} {category} {until}")

    def export(self, category: str, stretch: Stretch) -> None:
        out = self.folders.candidate(category)
        out.mkdir(parents=True, exist_ok=True)
        (out / "manifest.json").write_text(self.done[-1])

    def validate(self, bundle: Path) -> float:
        return self.scores.pop(0)

    def draw(self, category: str, stretch: Stretch) -> None:
        self.done.append(f"draw {category}")


@pytest.fixture
def folders(tmp_path: Path) -> Folders:
    (tmp_path / "models").mkdir()
    return Folders(tmp_path / ".campaign", tmp_path / "models")


def test_only_what_scores_better_ships(folders: Folders) -> None:
    steps = Scripted(folders, [50.0, 70.0, 60.0, 65.0, 69.0, 66.0, 67.0, 68.0])
    Campaign(folders, steps, 1000, lambda _: None).run(["can"])
    assert (folders.models / "can" / "manifest.json").read_text() == "run can 500"
    assert [path.name for path in folders.models.iterdir()] == ["can"]
    standing = load_standings(folders.state)["can"]
    assert (standing.milestones, standing.best, standing.best_samples) == (len(COURSE), 70.0, 500)
    lines = [json.loads(line) for line in folders.scores("can").read_text().splitlines()]
    assert lines[1] == {"samples": 500, "score": 70.0}


def test_what_ships_already_has_to_be_beaten(folders: Folders) -> None:
    (folders.models / "can").mkdir()
    (folders.models / "can" / "manifest.json").write_text("old")
    Campaign(folders, Scripted(folders, [80.0, *[79.0] * 8]), 1000, lambda _: None).run(["can"])
    assert (folders.models / "can" / "manifest.json").read_text() == "old"


def test_a_stopped_campaign_goes_on_where_it_was(folders: Folders) -> None:
    first = Scripted(folders, [50.0, 51.0], stop_at=750)
    with pytest.raises(KeyboardInterrupt):
        Campaign(folders, first, 1000, lambda _: None).run(["can"])
    second = Scripted(folders, [40.0, 41.0, 90.0, 91.0, 89.0, 92.0])
    Campaign(folders, second, 1000, lambda _: None).run(["can"])
    assert [step for step in second.done if "draw" not in step] == [
        "views can",
        "run can 750",
        "run can 900",
        "run can 1000",
        "anew can 500",
        "anew can 750",
        "anew can 1000",
    ]
    assert (folders.models / "can" / "manifest.json").read_text() == "anew can 1000"
    third = Scripted(folders, [])
    Campaign(folders, third, 1000, lambda _: None).run(["can"])
    assert third.done == []


def test_categories_that_others_start_from_come_first(folders: Folders) -> None:
    assert sorted(QUEUE) == sorted(CATEGORIES)
    assert all(QUEUE.index(source) < QUEUE.index(category) for category, source in WARM_STARTS.items())
    assert folders.start_from("can") is None
    for ships in ("bottle", "can"):
        (folders.models / ships).mkdir(parents=True)
        (folders.models / ships / "rotation.onnx").touch()
        assert folders.start_from("can") == folders.models / ships


def test_the_real_steps_lead_from_nothing_to_a_bundle(folders: Folders) -> None:
    """Far too little training to be of use, but every step is the one that a campaign takes."""
    steps = LocalSteps(folders, samples=36, views=8, sequences=1, instances=2, frames=3)
    steps.make_views("can")
    steps.train("can", BOTH, 18)
    first = torch.load(folders.run("can") / "state.pt", weights_only=True)["progress"]["samples"]
    steps.train("can", BOTH, 36)
    assert (first, torch.load(folders.run("can") / "state.pt", weights_only=True)["progress"]["samples"]) == (18, 36)
    steps.export("can", BOTH)
    assert 0 <= steps.validate(folders.candidate("can")) <= 100
    assert all("procedural-9" not in path.name for path in folders.sequences.rglob("*.npz")), "no test seed is drawn"
    replace_bundle(folders.candidate("can"), folders.models / "can")
    before = {path.name: path.read_bytes() for path in (folders.models / "can").iterdir()}
    steps.train("can", ROTATION_ANEW, 18)
    steps.export("can", ROTATION_ANEW)
    changed = {path.name for path in folders.candidate("can").iterdir() if path.read_bytes() != before[path.name]}
    assert changed == {"rotation.onnx", "manifest.json"}
