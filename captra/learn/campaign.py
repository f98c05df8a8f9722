"""One queue over all categories: views, training, the choice of a checkpoint, export where it got better, calibration.

It may be stopped at any minute: training saves itself, whatever else was under way is done again, and the state file
says how far each category is. Checkpoints are chosen on validation sequences; test seeds are never drawn from here.
"""

import contextlib
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Protocol

from captra.categories import get_category

MILESTONES = (0.25, 0.5, 0.75, 0.9, 1.0)
"""Shares of the samples after which a category's networks are exported and scored."""

WARM_STARTS: Mapping[str, str] = MappingProxyType(
    {
        "can": "bottle",
        "bowl": "bottle",
        "laptop": "mug",
        "camera": "mug",
        "laptop_articulated": "mug",
        "scissors": "mug",
        "glasses": "mug",
        "drawers": "mug",
    }
)
"""Whose networks a category starts from; others start from nothing, or from what ships of themselves."""

QUEUE = ("bottle", "mug", "can", "bowl", "laptop", "camera", "laptop_articulated", "scissors", "drawers", "glasses")
"""Those that others start from come first."""


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

    def run(self, category: str) -> Path:
        """State, log and checkpoints of the training."""
        return self.campaign / "runs" / category / "run"

    def candidate(self, category: str) -> Path:
        """The bundle that is being judged; its parent is a folder of bundles."""
        return self.campaign / "candidates" / category

    def scores(self, category: str) -> Path:
        """Validation scores, a line a milestone."""
        return self.run(category) / "validation.jsonl"

    def start_from(self, category: str) -> Path | None:
        """The bundle to start from: its own that ships, or that of the category that it starts from."""
        places = (self.models / category, self.models / WARM_STARTS.get(category, category))
        return next((place for place in places if (place / "rotation.onnx").exists()), None)


class Steps(Protocol):
    """The work of a campaign, each step of which can be repeated."""

    def make_views(self, category: str) -> None:
        """Make sure that there are enough training views."""

    def train(self, category: str, until: int) -> None:
        """Train until so many samples were seen."""

    def export(self, category: str) -> None:
        """Write the candidate bundle from the run's checkpoints, its confidence calibrated."""

    def validate(self, bundle: Path) -> float:
        """Score a bundle on validation sequences; higher is better."""

    def draw(self, category: str) -> None:
        """Draw what was learnt and scored so far."""


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
        if standing.milestones == len(MILESTONES):
            return
        self._tell(f"{category}: views")
        self._steps.make_views(category)
        shipped = self._folders.models / category
        if standing.best is None and (shipped / "manifest.json").exists():
            standing = self._keep(category, replace(standing, best=self._steps.validate(shipped)))
            self._tell(f"{category}: what ships scores {standing.best:.2f} on validation sequences")
        for number in range(standing.milestones, len(MILESTONES)):
            until = round(self._samples * MILESTONES[number])
            self._tell(f"{category}: training up to {until} samples")
            self._steps.train(category, until)
            self._steps.export(category)
            score = self._steps.validate(self._folders.candidate(category))
            self._note(category, until, score)
            self._steps.draw(category)
            if standing.best is None or score > standing.best:
                replace_bundle(self._folders.candidate(category), shipped)
                standing = replace(standing, best=score, best_samples=until)
            self._tell(f"{category}: {score:.2f} after {until} samples; {standing.best:.2f} ships")
            standing = self._keep(category, replace(standing, milestones=number + 1))

    def _keep(self, category: str, standing: Standing) -> Standing:
        self._standings[category] = standing
        partial = self._folders.state.with_suffix(".partial")
        partial.write_text(json.dumps({name: asdict(one) for name, one in self._standings.items()}, indent=1) + "\n")
        partial.replace(self._folders.state)
        return standing

    def _note(self, category: str, samples: int, score: float) -> None:
        path = self._folders.scores(category)
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


@dataclass(frozen=True)
class LocalSteps:
    """The steps on this machine; what other packages do is asked of the command line."""

    folders: Folders
    """Where things are."""
    samples: int
    """Of the whole run of each category; the learning rate follows them."""
    views: int = 12_000
    """Training views of each category."""
    sequences: int = 6
    """Validation sequences of each category."""
    frames: int = 60
    """Of each."""
    threads: int = 1
    """Of training."""
    meshes: Path | None = None
    """Library whose training objects are mixed in."""
    seed: int = 1
    """Of views, weights and perturbations."""

    def make_views(self, category: str) -> None:
        """Shards that are there already are kept."""
        command = [sys.executable, "-m", "captra.data.generate", "--category", category, "--count", str(self.views)]
        command += ["--seed", str(self.seed), "--out", str(self.folders.views(category))]
        run(command + (["--meshes", str(self.meshes)] if self.meshes else []))

    def train(self, category: str, until: int) -> None:
        """Go on with the run; the trainer saves when it stops."""
        from captra.data.dataset import ViewDataset
        from captra.learn.plan import Plan
        from captra.learn.provenance import provenance
        from captra.learn.training import Progress, Trainer

        views = self.folders.views(category)
        plan = Plan(samples=self.samples, seed=self.seed)
        trainer = Trainer(
            get_category(category), ViewDataset(views), plan, self.folders.run(category), provenance(views)
        )
        start = self.folders.start_from(category)
        if trainer.progress.samples == 0 and start is not None:
            trainer.start_from(get_category(start.name), start)
        if trainer.progress.samples >= until:
            return

        def stop_there(progress: Progress, _terms: dict[str, float]) -> None:
            if progress.samples >= until:
                raise MilestoneReached

        with contextlib.suppress(MilestoneReached):
            trainer.run(stop_there)

    def export(self, category: str) -> None:
        """As `captra export`, `captra fuse` and `captra calibrate` do."""
        out = self.folders.candidate(category)
        checkpoints = self.folders.run(category)
        command = [sys.executable, "-m", "captra", "export", "--category", category, "--out", str(out)]
        run([*command, *(w for n in ("coordinate", "rotation") for w in (f"--{n}", str(checkpoints / f"{n}.pt")))])
        on = ["--category", category, "--models", str(out.parent), "--cache", str(self.folders.sequences)]
        run([sys.executable, "-m", "captra", "fuse", *on, "--sequences", str(self.sequences)])
        calibrate = [sys.executable, "-m", "captra", "calibrate", *on]
        subprocess.run(calibrate, check=False)  # without right and wrong steps there is nothing to fit

    def validate(self, bundle: Path) -> float:
        """Mean of 5°5cm and oriented IoU, percent, over unseen procedural sequences with validation seeds."""
        from captra.evaluation.fusion_choice import worth
        from captra.evaluation.runner import ExportedNetworks, mean_over
        from captra.evaluation.sequence_cache import SequenceCache
        from captra.evaluation.sequences import VALIDATION_SEED, procedural
        from captra.evaluation.workers import Here

        cache = SequenceCache.open(self.folders.sequences)
        sources = procedural(bundle.name, self.sequences, cache, self.frames, VALIDATION_SEED)
        networks = ExportedNetworks(bundle, "realtime", "cpu", self.threads)
        return worth(mean_over(bundle.name, networks, sources, Here()))

    def draw(self, category: str) -> None:
        """Loss and validation score over the samples, beside the run's log."""
        from captra.learn.curves import plot_curves, plot_scores

        run_folder = self.folders.run(category)
        plot_curves(run_folder / "log.jsonl", run_folder / "curves.png")
        plot_scores(self.folders.scores(category), run_folder / "validation.png")


class MilestoneReached(Exception):  # noqa: N818 - it is no error
    """Training has come far enough for now."""


def run(command: Sequence[str]) -> None:
    """Run a command to its end; stopping this process stops it too.

    Raises:
        subprocess.CalledProcessError: it failed.
    """
    subprocess.run(command, check=True)


def yield_to_others() -> None:
    """Lower this process's priority, and that of all it starts."""
    os.nice(10)
