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


@dataclass(frozen=True)
class Stretch:
    """A part of a category's training, with a run of its own."""

    run: str
    """Names the folder of its state."""
    milestones: tuple[float, ...]
    """Shares of the samples after which the networks are exported and scored."""


BOTH = Stretch("run", (0.25, 0.5, 0.75, 0.9, 1.0))
"""Both networks; RotationNet soon starts from the little that CoordinateNet has learned."""
ROTATION_ANEW = Stretch("anew", (0.5, 0.75, 1.0))
"""RotationNet alone, from all that the best CoordinateNet has learned: where it was better than any other change."""
COURSE = tuple((stretch, share) for stretch in (BOTH, ROTATION_ANEW) for share in stretch.milestones)
"""All milestones of a category in turn."""

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

    def run(self, category: str, stretch: Stretch = BOTH) -> Path:
        """State, log and checkpoints of a stretch of the training."""
        return self.campaign / "runs" / category / stretch.run

    def candidate(self, category: str) -> Path:
        """The bundle that is being judged; its parent is a folder of bundles."""
        return self.campaign / "candidates" / category

    def scores(self, category: str, stretch: Stretch = BOTH) -> Path:
        """Validation scores, a line a milestone."""
        return self.run(category, stretch) / "validation.jsonl"

    def start_from(self, category: str) -> Path | None:
        """The bundle to start from: its own that ships, or that of the category that it starts from."""
        places = (self.models / category, self.models / WARM_STARTS.get(category, category))
        return next((place for place in places if (place / "rotation.onnx").exists()), None)


class Steps(Protocol):
    """The work of a campaign, each step of which can be repeated."""

    def make_views(self, category: str) -> None:
        """Make sure that there are enough training views."""

    def train(self, category: str, stretch: Stretch, until: int) -> None:
        """Train until so many samples were seen in this stretch."""

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
        self._tell(f"{category}: views")
        self._steps.make_views(category)
        shipped = self._folders.models / category
        if standing.best is None and (shipped / "manifest.json").exists():
            standing = self._keep(category, replace(standing, best=self._steps.validate(shipped)))
            self._tell(f"{category}: what ships scores {standing.best:.2f} on validation sequences")
        for number, (stretch, share) in list(enumerate(COURSE))[standing.milestones :]:
            until = round(self._samples * share)
            self._tell(f"{category}, {stretch.run}: training up to {until} samples")
            self._steps.train(category, stretch, until)
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
    instances: int = 24
    """Of each category, on which what the networks stay off by is measured."""
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
        mixed_in = ["--meshes", str(self.meshes)] if self.meshes else []
        views = ["--count", str(self.views), "--seed", str(self.seed), "--out", str(self.folders.views(category))]
        captra("generate", "--category", category, *views, *mixed_in)

    def train(self, category: str, stretch: Stretch, until: int) -> None:
        """Go on with the run; the trainer saves when it stops."""
        from captra.data.dataset import ViewDataset
        from captra.learn.plan import ROTATION, Plan
        from captra.learn.provenance import provenance
        from captra.learn.training import Progress, Trainer

        views = self.folders.views(category)
        networks = (ROTATION,) if stretch is ROTATION_ANEW else Plan.networks
        plan = Plan(samples=self.samples, seed=self.seed, networks=networks)
        trainer = Trainer(
            get_category(category), ViewDataset(views), plan, self.folders.run(category, stretch), provenance(views)
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

    def export(self, category: str, stretch: Stretch) -> None:
        """As `captra export` or `captra replace-network`, `captra fuse` and `captra calibrate` do."""
        out, checkpoints = self.folders.candidate(category), self.folders.run(category, stretch)
        rotation = ["--rotation", str(checkpoints / "rotation.pt")]
        if stretch is ROTATION_ANEW:
            replace_bundle(self.folders.models / category, out)
            captra("replace-network", "--bundle", str(out), *rotation)
        else:
            coordinate = ["--coordinate", str(checkpoints / "coordinate.pt")]
            captra("export", "--category", category, "--out", str(out), *coordinate, *rotation)
        on = ["--category", category, "--models", str(out.parent), "--cache", str(self.folders.sequences)]
        on += ["--sequences", str(self.sequences)]
        captra("fuse", *on, "--frames", str(self.frames), "--instances", str(self.instances))
        with contextlib.suppress(subprocess.CalledProcessError):  # without right and wrong steps is nothing to fit
            captra("calibrate", *on)

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

    def draw(self, category: str, stretch: Stretch) -> None:
        """Loss and validation score over the samples, beside the run's log."""
        from captra.learn.curves import plot_curves, plot_scores

        run_folder = self.folders.run(category, stretch)
        plot_curves(run_folder / "log.jsonl", run_folder / "curves.png")
        plot_scores(self.folders.scores(category, stretch), run_folder / "validation.png")


class MilestoneReached(Exception):  # noqa: N818 - it is no error
    """Training has come far enough for now."""


def captra(*arguments: str) -> None:
    """Run one of this project's commands to its end; stopping this process stops it too.

    Raises:
        subprocess.CalledProcessError: it failed.
    """
    subprocess.run([sys.executable, "-m", "captra", *arguments], check=True)


def yield_to_others() -> None:
    """Lower this process's priority, and that of all it starts."""
    os.nice(10)
