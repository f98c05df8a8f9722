import json
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from captra.categories import CATEGORIES
from captra.learn.campaign import Campaign, Folders, load_standings
from captra.learn.cli import check_alike
from captra.learn.course import BOTH, COURSE, QUEUE, ROTATION_ANEW, WARM_STARTS, Stretch


@dataclass
class Scripted:
    """Steps whose validation scores are given."""

    folders: Folders
    scores: list[float]
    done: list[str] = field(default_factory=list)
    stop_at: int = 10**9
    seen: dict[str, int] = field(default_factory=dict)

    def make_views(self, category: str) -> None:
        self.done.append(f"views {category}")

    def train(self, category: str, stretch: Stretch, until: int) -> int:
        if until >= self.stop_at:
            raise KeyboardInterrupt
        self.done.append(f"{stretch.run} {category} {until}")
        run = f"{stretch.run} {stretch.owner(category)}"
        self.seen[run] = max(until, self.seen.get(run, 0))
        return self.seen[run]

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
    steps = Scripted(folders, [50.0, 70.0, *[60.0] * 12])
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
    Campaign(folders, Scripted(folders, [80.0, *[79.0] * 14]), 1000, lambda _: None).run(["can"])
    assert (folders.models / "can" / "manifest.json").read_text() == "old"


def test_a_stopped_campaign_goes_on_where_it_was(folders: Folders) -> None:
    first = Scripted(folders, [50.0, 51.0], stop_at=750)
    with pytest.raises(KeyboardInterrupt):
        Campaign(folders, first, 1000, lambda _: None).run(["can"])
    second = Scripted(folders, [40.0, 41.0, 90.0, 91.0, 89.0, 92.0, 88.0, 93.0, 87.0, 86.0, 85.0, 84.0])
    Campaign(folders, second, 1000, lambda _: None).run(["can"])
    assert [step for step in second.done if "draw" not in step] == [
        "views can",
        "views bottle",
        "views bowl",
        "run can 750",
        "run can 900",
        "run can 1000",
        "anew can 500",
        "anew can 750",
        "anew can 1000",
        "further can 500",
        "further can 750",
        "further can 1000",
        "rotation-further can 500",
        "rotation-further can 750",
        "rotation-further can 1000",
    ]
    assert (folders.models / "can" / "manifest.json").read_text() == "further can 750"
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


def test_what_another_category_has_trained_already_is_judged_once(folders: Folders) -> None:
    steps = Scripted(folders, [50.0] * 14 + [60.0] * 5 + [70.0] + [60.0] * 4)
    Campaign(folders, steps, 1000, lambda _: None).run(["bottle", "can"])
    assert steps.scores == []
    assert folders.run("can", ROTATION_ANEW) == folders.run("bottle", ROTATION_ANEW)
    assert folders.run("can", BOTH) != folders.run("bottle", BOTH)
    standing = load_standings(folders.state)["can"]
    assert (standing.milestones, standing.best) == (len(COURSE), 70.0)
    assert (folders.models / "can" / "manifest.json").read_text() == "anew can 1000"
    assert len(folders.scores("can", ROTATION_ANEW).read_text().splitlines()) == 1


def test_who_is_served_by_another_comes_after_it_and_is_shown_to_it() -> None:
    assert ROTATION_ANEW.shown("can") == ROTATION_ANEW.shown("bottle") == ("bottle", "bowl", "can")
    assert ROTATION_ANEW.shown("mug") == ("mug",)
    assert all(QUEUE.index(owner) < QUEUE.index(name) for name, owner in ROTATION_ANEW.served_by.items())
    for name, owner in ROTATION_ANEW.served_by.items():
        check_alike(CATEGORIES[owner], [CATEGORIES[name]])
