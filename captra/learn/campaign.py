"""One queue over all categories: views, training, the choice of a checkpoint, export where it got better, calibration.

It may be stopped at any minute: training saves itself, whatever else was under way is done again, and the state file
says how far each category is. Checkpoints are chosen on validation sequences; test seeds are never drawn from here.
"""

import json
import shutil
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Protocol

from captra.learn.course import BOTH, COURSE, QUEUE, WARM_STARTS, Stretch


@dataclass(frozen=True)
class Standing:
    """How far one category is."""

    milestones: int = 0
    """Milestones that were trained, exported and scored."""
    best: float | None = None
    """Validation score of the bundle that ships; None if there is none."""
    best_samples: int = 0
    """Samples after which it was reached; 0 for a bundle that was there before."""


@dataclass(frozen=True)
class Folders:
    """Where a campaign reads and writes."""

    campaign: Path
    """State, views, runs and candidates."""
    models: Path
    """Bundles that ship."""

    @property
    def state(self) -> Path:
        """The state file."""
        return self.campaign / "campaign.json"

    @property
    def sequences(self) -> Path:
        """Simulated sequences."""
        return self.campaign / "sequences"

    def views(self, category: str) -> Path:
        """Training views."""
        return self.campaign / "views" / category / "train"

    def run(self, category: str, stretch: Stretch = BOTH) -> Path:
        """State, log and checkpoints of a stretch of the training."""
        return self.campaign / "runs" / stretch.owner(category) / stretch.run

    def candidate(self, category: str) -> Path:
        """The bundle that is being judged; its parent is a folder of bundles."""
        return self.campaign / "candidates" / category

    def scores(self, category: str, stretch: Stretch = BOTH) -> Path:
        """Validation scores, a line a milestone."""
        return self.campaign / "runs" / category / stretch.run / "validation.jsonl"

    def start_from(self, category: str) -> Path | None:
        """The bundle to start from: its own that ships, or that of the category that it starts from."""
        places = (self.models / category, self.models / WARM_STARTS.get(category, category))
        return next((place for place in places if (place / "rotation.onnx").exists()), None)


class Steps(Protocol):
    """The work of a campaign, each step of which can be repeated."""

    def make_views(self, category: str) -> None:
        """Make sure that there are enough training views."""

    def train(self, category: str, stretch: Stretch, until: int) -> int:
        """Train until so many samples were seen in this stretch, if they were not yet; returns how many were."""

    def export(self, category: str, stretch: Stretch) -> None:
        """Write the candidate bundle from the stretch's checkpoints, its confidence calibrated."""

    def validate(self, bundle: Path) -> float:
        """Score a bundle on validation sequences; higher is better."""

    def draw(self, category: str, stretch: Stretch) -> None:
        """Draw what was learnt and scored so far in this stretch."""


class Campaign:
    """The queue and its state."""

    def __init__(self, folders: Folders, steps: Steps, samples: int, tell: Callable[[str], None]) -> None:
        self._folders, self._steps, self._samples, self._tell = folders, steps, samples, tell
        folders.campaign.mkdir(parents=True, exist_ok=True)
        self._standings = load_standings(folders.state)

    def run(self, categories: Sequence[str] = QUEUE) -> None:
        """Work through the queue from where it stands."""
        for category in categories:
            self._one(category)

    def _one(self, category: str) -> None:
        standing = self._standings.get(category, Standing())
        if standing.milestones == len(COURSE):
            return
        for name in dict.fromkeys(name for stretch, _ in COURSE for name in stretch.shown(category)):
            self._tell(f"{category}: views of {name}")
            self._steps.make_views(name)
        shipped = self._folders.models / category
        if standing.best is None and (shipped / "manifest.json").exists():
            standing = self._keep(category, replace(standing, best=self._steps.validate(shipped)))
            self._tell(f"{category}: what ships scores {standing.best:.2f} on validation sequences")
        for number, (stretch, share) in list(enumerate(COURSE))[standing.milestones :]:
            until = round(self._samples * share)
            self._tell(f"{category}, {stretch.run}: training up to {until} samples")
            seen = self._steps.train(category, stretch, until)
            if any(seen >= round(self._samples * later) for later in stretch.milestones if later > share):
                standing = self._keep(category, replace(standing, milestones=number + 1))
                continue  # another category's turn brought it further
            self._steps.export(category, stretch)
            score = self._steps.validate(self._folders.candidate(category))
            self._note(self._folders.scores(category, stretch), until, score)
            self._steps.draw(category, stretch)
            if standing.best is None or score > standing.best:
                replace_bundle(self._folders.candidate(category), shipped)
                standing = replace(standing, best=score, best_samples=until)
            self._tell(f"{category}, {stretch.run}: {score:.2f} after {until} samples; {standing.best:.2f} ships")
            standing = self._keep(category, replace(standing, milestones=number + 1))

    def _keep(self, category: str, standing: Standing) -> Standing:
        self._standings[category] = standing
        partial = self._folders.state.with_suffix(".partial")
        partial.write_text(json.dumps({name: asdict(one) for name, one in self._standings.items()}, indent=1) + "\n")
        partial.replace(self._folders.state)
        return standing

    def _note(self, path: Path, samples: int, score: float) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a") as log:
            log.write(json.dumps({"samples": samples, "score": score}) + "\n")


def load_standings(path: Path) -> dict[str, Standing]:
    """What a campaign has reached; nothing without a state file."""
    if not path.exists():
        return {}
    return {name: Standing(**content) for name, content in json.loads(path.read_text()).items()}


def replace_bundle(candidate: Path, shipped: Path) -> None:
    """Put a bundle in the place of another; a reader finds the old one or the new one, apart from an instant."""
    fresh = shipped.with_name(f".{shipped.name}.fresh")
    old = shipped.with_name(f".{shipped.name}.old")
    for left in (fresh, old):
        shutil.rmtree(left, ignore_errors=True)
    shutil.copytree(candidate, fresh)
    if shipped.exists():
        shipped.rename(old)
    fresh.rename(shipped)
    shutil.rmtree(old, ignore_errors=True)
