"""What single ideas for a cheaper frame are worth: the networks of a mug, each way of running them in turns.

python -m benchmarks.steps --provider openvino

Weights are untrained: speed does not depend on them.
"""

import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import chain
from pathlib import Path
from time import perf_counter
from typing import Annotated
from unittest import mock

import numpy as np
import typer
from rich.console import Console
from rich.table import Table

from benchmarks.untrained import write_untrained
from captra.bench.machine import this_machine
from captra.categories import get_category
from captra.depth_images import DepthImage, Intrinsics
from captra.geometry import Pose
from captra.looking import choose_points
from captra.observations import Observation, PointCloud
from captra.runtime.cores import available_cores
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES, InputSampling, Profile, build_neighborhoods, farthest_points, part_neighborhoods
from captra.segmentation import NOTHING_KNOWN
from captra.side_by_side import IN_TURN, One, Other, WhileCoresAreFree
from export import onnx_export
from export.inputs import made_up_clouds

Step = tuple[str, Callable[[], object]]
PIECES = (1, onnx_export.PIECES)
STACKED = ("mug", "laptop_articulated", "drawers")
"""One, two and four parts, a cloud each."""
FOCAL_PX = 600.0
BALL_RADIUS_PX = 60.0
"""Of what is near: a mug of 10 cm, half a metre away."""
SERVED = InputSampling(surroundings_weight=0.4)
"""As in the bundles."""
WARM_UP = 5


def main(
    provider: Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")] = "auto",
    repetitions: Annotated[int, typer.Option(help="Of each way.")] = 40,
) -> None:
    """Print milliseconds of every step, 10th percentile and median."""
    machine = this_machine()
    console = Console(width=120)
    console.print(f"{machine.cpu}, {machine.cores} cores, Python {machine.python}, {machine.packages}")
    result = Table("step", "profile", "ms, p10 / p50", title=f"provider {provider}", title_justify="left")
    with tempfile.TemporaryDirectory() as folder:
        for pieces in PIECES:
            with mock.patch.object(onnx_export, "PIECES", pieces):
                write_untrained("mug", Path(folder, str(pieces)))
        for category in STACKED:
            write_untrained(category, Path(folder, category))
        for profile in PROFILES.values():
            ways = (networks_of(Path(folder), profile, provider), stacks_of(Path(folder), profile, provider))
            steps = chain(*ways, neighborhoods_of(profile), crops_of(profile))
            for label, step in steps:
                result.add_row(label, profile.name, timed(step, repetitions))
    console.print(result)


def networks_of(folder: Path, profile: Profile, provider: str) -> Iterator[Step]:
    """Both networks, with groups worked through as a whole and in pieces, each way of sharing the cores."""
    (cloud,) = made_up_clouds(1, profile)
    neighborhoods = build_neighborhoods(cloud, profile)
    for pieces in PIECES:
        networks = OnnxNetworks.load(folder / str(pieces), profile, provider)
        one = partial(networks.coordinates, cloud, neighborhoods)
        other = partial(networks.rotations, cloud[None], [neighborhoods])
        label = f"networks, groups in {pieces} piece(s)"
        yield f"{label}, in turn", partial(IN_TURN, one, other)
        yield f"{label}, a new thread a frame", partial(started_anew, one, other)
        yield f"{label}, side by side", partial(WhileCoresAreFree(networks.threads), one, other)


def stacks_of(folder: Path, profile: Profile, provider: str) -> Iterator[Step]:
    """RotationNet for the clouds of one, two and four parts at once: what a batch over sessions could spare."""
    for category in STACKED:
        networks = OnnxNetworks.load(folder / category, profile, provider, threads=1)
        clouds = made_up_clouds(networks.category.num_parts, profile)
        neighborhoods = [build_neighborhoods(cloud, profile) for cloud in clouds]
        label = f"RotationNet on one thread, {len(clouds)} cloud(s) at once, all of them"
        yield label, partial(networks.rotations, np.stack(clouds), neighborhoods)


def neighborhoods_of(profile: Profile) -> Iterator[Step]:
    """What comes before the networks."""
    (cloud,) = made_up_clouds(1, profile)
    scene = np.concatenate([cloud, cloud + 0.001, cloud + 0.002]).astype(np.float32)
    yield "farthest points, of three times as many", partial(farthest_points, scene, profile.points)
    yield "neighbourhoods, in turn", partial(part_neighborhoods, cloud[None], profile)
    ways = WhileCoresAreFree(available_cores())
    yield "neighbourhoods, side by side", partial(part_neighborhoods, cloud[None], profile, ways)


def crops_of(profile: Profile) -> Iterator[Step]:
    """From all that a camera sees, 640 × 480 pixels, to the points that the networks are given."""
    u, v = np.meshgrid(np.arange(640) - 319.5, np.arange(480) - 239.5)
    depth_m = np.where(np.hypot(u, v) < BALL_RADIUS_PX, 0.5, 1.0).astype(np.float32)
    cloud = np.stack([u * depth_m / FOCAL_PX, v * depth_m / FOCAL_PX, depth_m], axis=-1).reshape(-1, 3)
    image = DepthImage((1e3 * depth_m).astype(np.uint16), 1e-3, Intrinsics(FOCAL_PX, FOCAL_PX, 319.5, 239.5))
    around = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0.0, 0.5]]), np.full((1, 3), 0.12))
    seen: tuple[tuple[str, Observation], ...] = (("depth image", image), ("cloud", PointCloud.of(cloud)))
    for label, observation in seen:
        arguments = (observation, around, get_category("mug"), profile.points, SERVED, NOTHING_KNOWN)
        yield f"crop and sampling, whole {label} of 307,200 points", partial(choose_points, *arguments)


def started_anew(one: Callable[[], One], other: Callable[[], Other]) -> tuple[One, Other]:
    """Side by side in a thread that is started for it."""
    with ThreadPoolExecutor(1) as pool:
        future = pool.submit(one)
        answer = other()
    return future.result(), answer


def timed(step: Callable[[], object], repetitions: int) -> str:
    """10th percentile and median."""
    durations_ms = []
    for _ in range(repetitions + WARM_UP):
        started_s = perf_counter()
        step()
        durations_ms.append(1e3 * (perf_counter() - started_s))
    low, middle = np.percentile(durations_ms[WARM_UP:], (10, 50))
    return f"{low:.2f} / {middle:.2f}"


if __name__ == "__main__":
    typer.run(main)
