"""Training of both networks of one category, on batches they share; stops and resumes at any step."""

import json
import time
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import torch
from torch import nn

from captra.categories import Category
from captra.data.view import View
from captra.errors import UserError
from captra.learn.checkpoint import CheckpointError, load_coordinate_net, load_rotation_net, save_checkpoint
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.from_bundle import coordinate_net_of_graph, restore_norms, rotation_net_of_graph
from captra.learn.learner import Learner
from captra.learn.objectives import coordinate_objective, rotation_objective
from captra.learn.perturbation import PerturbationMix, rotation_fusion_for
from captra.learn.plan import COORDINATE, ROTATION, Plan
from captra.learn.pointnet2 import copy_backbone
from captra.learn.rotation_net import RotationNet
from captra.learn.samples import Batch, Sample, SampleMaker, stack
from captra.sampling import NoPointsError, Profile

STATE_FILE = "state.pt"
LOG_FILE = "log.jsonl"
PREFETCH = 2
NORM_BATCHES = 12
"""Batches that the statistics of norms are measured on."""
SOME_POINTS = 64
"""RotationNet's heads have no such statistics: they need not run on many."""


MOST_REFUSED = 2_000
"""Views in a row that show too little of the object before training gives up."""


class PoorViewsError(UserError):
    """No view shows enough to learn from."""


def transplant(source: nn.Module, target: nn.Module) -> None:
    """Copy every tensor that has the same name and shape in both networks."""
    state = source.state_dict()
    fitting = {
        name: state[name]
        for name, tensor in target.state_dict().items()
        if name in state and state[name].shape == tensor.shape
    }
    target.load_state_dict(fitting, strict=False)


class Views(Protocol):
    """A collection of rendered views that may grow while training runs."""

    def __len__(self) -> int: ...

    def __getitem__(self, index: int) -> View: ...

    def refresh(self) -> int:
        """Look for views that were added; returns how many there are."""


@dataclass
class Progress:
    """How far a run is."""

    samples: int = 0
    """Samples seen so far."""
    seconds: float = 0.0
    """Time spent so far, over all sittings."""
    rotation_started: bool = False
    """Whether RotationNet has taken over CoordinateNet's backbone."""


class Trainer:
    """One category's run in a folder that holds its state and its log."""

    def __init__(
        self, category: Category, views: Views, plan: Plan, folder: Path, provenance: Mapping[str, Any] | None = None
    ) -> None:
        torch.manual_seed(plan.seed)
        self.category, self.views, self.plan, self.folder = category, views, plan, folder
        self.coordinate = Learner(CoordinateNet(category.num_parts, category.num_classes), plan)
        self.rotation = Learner(RotationNet(category.num_parts, category.symmetric), plan)
        self.progress = Progress()
        self._provenance = dict(provenance or {})
        self._mix = PerturbationMix.for_category(category)
        self._make_sample = SampleMaker(category, plan.density, self._mix)
        folder.mkdir(parents=True, exist_ok=True)
        if (folder / STATE_FILE).exists():
            self._resume()

    def start_from(self, source: Category, folder: Path) -> None:
        """Take over what fits of networks of this category or another: of a run, of shipped checkpoints or a bundle.

        Raises:
            CheckpointError: they are missing, or not of `source`.
        """
        if (folder / "coordinate.onnx").exists():
            coordinate = coordinate_net_of_graph(folder / "coordinate.onnx", source)
            rotation = rotation_net_of_graph(folder / "rotation.onnx", source)
            transplant(coordinate, self.coordinate.network)
            self._take_rotation(rotation, source)
            self._restore_norms()
        else:
            transplant(load_coordinate_net(folder / "coordinate.pt", source), self.coordinate.network)
            self._take_rotation(load_rotation_net(folder / "rotation.pt", source), source)
        if self.plan.anew:
            self.rotation = Learner(RotationNet(self.category.num_parts, self.category.symmetric), self.plan)
            copy_backbone(self.coordinate.network.backbone, self.rotation.network.backbone)
        self.coordinate.restart()
        self.rotation.restart()
        self.progress.rotation_started = True

    def _take_rotation(self, rotation: RotationNet, source: Category) -> None:
        transplant(rotation, self.rotation.network)
        if source.symmetric == self.category.symmetric:
            for head in self.rotation.network.heads[source.num_parts :]:
                head.load_state_dict(rotation.heads[0].state_dict())

    def _restore_norms(self) -> None:
        """Networks that came from a bundle have lost the statistics of their norms."""
        batches = [self._prepare(self.plan.batch_size * number) for number in range(NORM_BATCHES)]

        def show(objective: Callable[[Batch], object]) -> None:
            for batch in batches:
                objective(batch)

        coordinate, rotation = self.coordinate.network.eval(), self.rotation.network.eval()
        restore_norms(coordinate, lambda: show(lambda batch: coordinate_objective(coordinate, batch, self.category)))
        restore_norms(
            rotation, lambda: show(lambda batch: rotation_objective(rotation, batch, self.category, SOME_POINTS))
        )
        coordinate.train()
        rotation.train()

    def run(self, report: Callable[[Progress, dict[str, float]], None], save_every_s: float = 120.0) -> None:
        """Train until the plan's samples are used up; interrupting saves and loses nothing."""
        threads = torch.get_num_threads()
        pool = ThreadPoolExecutor(2, initializer=torch.set_num_threads, initargs=(threads,))
        try:
            saved = time.monotonic()
            for batch in self._batches():
                started = time.monotonic()
                terms = self._step(batch, pool)
                self.progress.samples += len(batch.labels)
                self.progress.seconds += time.monotonic() - started
                report(self.progress, terms)
                self._log(terms)
                if time.monotonic() - saved > save_every_s:
                    self.save()
                    saved = time.monotonic()
        finally:
            pool.shutdown()
            self.save()

    def save(self) -> None:
        """Write the state, and the averaged weights as checkpoints; each file is replaced whole."""
        state = {
            "category": self.category.name,
            "progress": vars(self.progress),
            "coordinate": self.coordinate.state_dict(),
            "rotation": self.rotation.state_dict(),
        }
        temporary = self.folder / (STATE_FILE + ".partial")
        torch.save(state, temporary)
        temporary.replace(self.folder / STATE_FILE)
        training = {
            "samples": self.progress.samples,
            "batch_size": self.plan.batch_size,
            "seed": self.plan.seed,
            "views": len(self.views),
            "input_sampling": asdict(self.plan.density),
            "rotation_fusion": rotation_fusion_for(self.category),
            **self._provenance,
        }
        save_checkpoint(self.folder / "coordinate.pt", self.coordinate.averaged, training)
        save_checkpoint(self.folder / "rotation.pt", self.rotation.averaged, training)

    def _resume(self) -> None:
        state = torch.load(self.folder / STATE_FILE, weights_only=True)
        if "optimizers" not in state["coordinate"]:
            raise CheckpointError(
                f"{self.folder / STATE_FILE} is of an earlier version: give the run another name with --run; "
                f"--start-from {self.folder} takes over its weights from a copy that is called {self.category.name}"
            )
        self.progress = Progress(**state["progress"])
        self.coordinate.load_state_dict(state["coordinate"])
        self.rotation.load_state_dict(state["rotation"])

    def _step(self, batch: Batch, pool: Executor) -> dict[str, float]:
        """One step of both networks at a time; they share nothing but the batch."""
        rate = self.plan.learning_rate_at(self.progress.samples)
        steps = [pool.submit(self._coordinate_step, batch, rate)] if COORDINATE in self.plan.networks else []
        due = self.progress.rotation_started or self.progress.samples >= self.plan.head_start * self.plan.samples
        if due and ROTATION in self.plan.networks:
            self._start_rotation()
            steps.append(pool.submit(self._rotation_step, batch, rate))
        return {name: value for step in steps for name, value in step.result().items()}

    def _coordinate_step(self, batch: Batch, rate: float) -> dict[str, float]:
        with torch.autocast("cpu", torch.bfloat16):
            loss, terms = coordinate_objective(self.coordinate.network, batch, self.category)
        self.coordinate.step(loss, rate)
        return {name: float(term.detach()) for name, term in terms.items()}

    def _start_rotation(self) -> None:
        if not self.progress.rotation_started:
            copy_backbone(self.coordinate.averaged.backbone, self.rotation.network.backbone)
            self.rotation.restart()
            self.progress.rotation_started = True

    def _rotation_step(self, batch: Batch, rate: float) -> dict[str, float]:
        with torch.autocast("cpu", torch.bfloat16):
            head_points = int(self.plan.rotation_share * batch.labels.shape[1])
            loss, terms = rotation_objective(self.rotation.network, batch, self.category, head_points)
        self.rotation.step(loss, rate)
        return {f"rotation/{name}": float(term.detach()) for name, term in terms.items()}

    def _batches(self) -> Iterator[Batch]:
        """Batches from where the run stands, prepared a little ahead."""
        with ThreadPoolExecutor(1) as pool:
            pending: list[Future[Batch]] = []
            start = self.progress.samples
            while start < self.plan.samples or pending:
                while start < self.plan.samples and len(pending) < PREFETCH:
                    pending.append(pool.submit(self._prepare, start))
                    start += self.plan.batch_size
                yield pending.pop(0).result()

    def _prepare(self, start: int) -> Batch:
        rng = np.random.default_rng([self.plan.seed, start])
        profiles = self.plan.stage_at(start).profiles
        profile = profiles[int(rng.integers(len(profiles)))]
        self.views.refresh()
        samples: list[Sample] = []
        refused = 0
        while len(samples) < self.plan.batch_size:
            sample = self._draw(profile, rng)
            if sample is not None:
                samples.append(sample)
                continue
            refused += 1
            if refused > MOST_REFUSED and not samples:
                raise PoorViewsError(
                    f"{MOST_REFUSED} views show fewer than {self.plan.least_object_points} points of the object: "
                    "generate others"
                )
        return stack(samples)

    def _draw(self, profile: Profile, rng: np.random.Generator) -> Sample | None:
        """A sample of any view; None where it shows too little."""
        view = self.views[int(rng.integers(len(self.views)))]
        if np.count_nonzero(view.labels < self.category.num_parts) < self.plan.least_object_points:
            return None
        try:
            return self._make_sample(view, profile, rng)
        except NoPointsError:
            return None

    def _log(self, terms: dict[str, float]) -> None:
        with (self.folder / LOG_FILE).open("a") as log:
            log.write(json.dumps({"samples": self.progress.samples, **terms}) + "\n")
