"""The steps of a campaign on this machine."""

import contextlib
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from captra.categories import get_category
from captra.learn.campaign import Folders, replace_bundle
from captra.learn.course import BOTH, Stretch
from captra.learn.plan import Plan


@dataclass(frozen=True)
class LocalSteps:
    """Trains in this process; what other packages do is asked of the command line."""

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

    def train(self, category: str, stretch: Stretch, until: int) -> int:
        """Go on with the run; the trainer saves when it stops."""
        from captra.data.dataset import ViewDataset
        from captra.learn.provenance import provenance
        from captra.learn.training import Progress, Trainer

        owner, views = stretch.owner(category), [self.folders.views(name) for name in stretch.shown(category)]
        plan = Plan(samples=self.samples, seed=self.seed, networks=stretch.networks, anew=stretch.anew)
        trainer = Trainer(
            get_category(owner), ViewDataset(*views), plan, self.folders.run(category, stretch), provenance(*views)
        )
        start = self.folders.start_from(owner)
        if trainer.progress.samples == 0 and start is not None:
            trainer.start_from(get_category(start.name), start)

        def stop_there(progress: Progress, _terms: dict[str, float]) -> None:
            if progress.samples >= until:
                raise MilestoneReached

        if trainer.progress.samples < until:
            with contextlib.suppress(MilestoneReached):
                trainer.run(stop_there)
        return trainer.progress.samples

    def export(self, category: str, stretch: Stretch) -> None:
        """As `captra export` or `captra replace-network`, `captra fuse` and `captra calibrate` do."""
        out, checkpoints = self.folders.candidate(category), self.folders.run(category, stretch)
        trained = [word for name in stretch.networks for word in (f"--{name}", str(checkpoints / f"{name}.pt"))]
        if stretch is BOTH:
            captra("export", "--category", category, "--out", str(out), *trained)
        else:
            replace_bundle(self.folders.models / category, out)
            captra("replace-network", "--bundle", str(out), *trained)
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

        log, scores = self.folders.run(category, stretch) / "log.jsonl", self.folders.scores(category, stretch)
        plot_curves(log, log.with_name("curves.png"))
        plot_scores(scores, scores.with_suffix(".png"))


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
