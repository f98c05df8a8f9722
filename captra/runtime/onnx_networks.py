"""CoordinateNet and RotationNet of a bundle, run by ONNX Runtime."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float32

from captra.categories import Category, get_category
from captra.joint_projection import JOINT_PROJECTIONS, JointProjection
from captra.mirrors import MIRRORS, Answer
from captra.pose_memory import FoundError
from captra.rotation_fusion import ROTATION_FUSIONS, RotationFusion
from captra.runtime.bundle import COORDINATE, ROTATION, BundleError, Manifest, load_manifest, verify
from captra.runtime.cores import available_cores
from captra.runtime.providers import Provider, choose_provider
from captra.sampling import InputSampling, Neighborhoods, Profile
from captra.side_by_side import SideBySide, WhileCoresAreFree

Feed = dict[str, np.ndarray]


@dataclass(frozen=True, eq=False)
class OnnxNetworks:
    """Satisfies `captra.looking.Networks`; may be shared by threads, since sessions keep nothing between two runs."""

    manifest: Manifest
    """What the bundle says of itself."""
    category: Category
    """What the networks were trained on."""
    profile: Profile
    """Shapes of the inputs."""
    provider: Provider
    """What runs them."""
    threads: int
    """Of both networks together."""
    rotated_points: int
    """Points, the first ones of a cloud, that RotationNet answers for."""
    side_by_side: SideBySide
    """How two pieces of work share these threads."""
    _coordinate: Any
    _rotation: Any

    @classmethod
    def load(
        cls,
        bundle_folder: Path,
        profile: Profile,
        provider: str = "auto",
        threads: int | None = None,
        side_by_side: SideBySide | None = None,
    ) -> "OnnxNetworks":
        """Load both networks for one profile.

        Args:
            bundle_folder: as written by `captra export`.
            profile: shapes of the inputs; other shapes are refused later.
            provider: auto, cpu, openvino or cuda.
            threads: of both networks together; by default as many as the container may use.
            side_by_side: how work shares these threads, by default for these networks alone.

        Raises:
            BundleError: the bundle is damaged, incomplete or of another version.
            ProviderError: the provider is unknown or not installed.
            UnknownCategoryError: the bundle is of a category that this version does not know.
        """
        import onnxruntime

        manifest = load_manifest(bundle_folder)
        verify(bundle_folder, manifest)
        category = get_category(manifest.category)
        if manifest.parts != category.parts:
            raise BundleError(
                f"{bundle_folder} has the parts {', '.join(manifest.parts)}, but {category.name} has "
                f"{', '.join(category.parts)}: export it again with this version of captra"
            )
        threads = threads or available_cores()
        available = onnxruntime.get_available_providers()
        rotated = rotated_points_of(manifest.rotation_share, profile)
        lengths = axis_lengths(profile) | {"H": rotated}
        sessions = []
        for name, parts in ((COORDINATE, 1), (ROTATION, category.num_parts)):
            runs = runs_at_a_time(threads, parts)
            chosen = choose_provider(provider, threads, available, runs=runs)
            sessions.append(open_session(bundle_folder / name, lengths, chosen, -(-threads // runs)))
        shared = side_by_side or WhileCoresAreFree(threads)
        return cls(manifest, category, profile, chosen, threads, rotated, shared, *sessions)

    @property
    def input_sampling(self) -> InputSampling:
        """How the points were drawn in training."""
        return self.manifest.input_sampling

    @property
    def rotation_fusion(self) -> RotationFusion:
        """Whose word counts for rotations."""
        return ROTATION_FUSIONS[self.manifest.rotation_fusion]

    @property
    def joint_projection(self) -> JointProjection:
        """How rotations are kept on the joints."""
        return JOINT_PROJECTIONS[self.manifest.joint_projection]

    @property
    def found_error(self) -> FoundError:
        """By how much the networks err on one object all the time."""
        return FoundError.measured(self.manifest.found_error)

    def coordinates(
        self, points_canonical: Float32[np.ndarray, "points 3"], neighborhoods: Neighborhoods
    ) -> tuple[Float32[np.ndarray, "classes points"], Float32[np.ndarray, "parts points 3"]]:
        """Class probabilities and normalized coordinates, from the root's canonical cloud."""

        def ask(points: Float32[np.ndarray, "points 3"]) -> Answer:
            segmentation, coordinates = self._coordinate.run(
                ["segmentation", "coordinates"], feed(points[None], [neighborhoods])
            )
            return segmentation[0], coordinates[0]

        return MIRRORS[self.manifest.mirror](ask, points_canonical, self.category)

    def rotations(
        self, points_canonical: Float32[np.ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Float32[np.ndarray, "parts rotated_points width"]:
        """Raw residual rotations of the first points; part j from cloud j."""
        inputs = feed(points_canonical, neighborhoods)
        inputs["nearest1"] = inputs["nearest1"][:, : self.rotated_points]
        (rotation,) = self._rotation.run(["rotation"], inputs)
        return rotation  # type: ignore[no-any-return]


def rotated_points_of(share: float, profile: Profile) -> int:
    """How many points RotationNet answers for."""
    return max(1, round(share * profile.points))


def runs_at_a_time(threads: int, parts: int) -> int:
    """How many runs of a graph share the threads.

    Both networks run side by side, with half the threads each: one thread to a graph wastes nothing on waiting for the
    other after every layer. A graph for several parts has much more to do than the one beside it and takes them all.
    """
    return min(2, threads) if parts == 1 else 1


def feed(points_canonical: Float32[np.ndarray, "clouds points 3"], neighborhoods: Sequence[Neighborhoods]) -> Feed:
    """A graph's inputs by name; a single cloud is not copied."""

    def batch(arrays: Sequence[np.ndarray]) -> np.ndarray:
        return arrays[0][None] if len(arrays) == 1 else np.stack(arrays)

    inputs = {"points": points_canonical}
    for level in ("groups1", "groups2"):
        by_radius = zip(*(getattr(n, level) for n in neighborhoods), strict=True)
        inputs |= {f"{level.replace('groups', 'group')}_{i}": batch(groups) for i, groups in enumerate(by_radius)}
    inputs |= {name: batch([getattr(n, name) for n in neighborhoods]) for name in ("nearest1", "nearest2")}
    return inputs


def axis_lengths(profile: Profile) -> dict[str, int]:
    """Length of each dynamic axis of the graphs under a profile."""
    first, second = profile.groups
    return {
        "N": profile.points,
        "M1": profile.centroids[0],
        "M2": profile.centroids[1],
        **{f"k1_{i}": k for i, k in enumerate(first)},
        **{f"k2_{i}": k for i, k in enumerate(second)},
    }


def open_session(path: Path, lengths: Mapping[str, int], provider: Provider, threads: int) -> Any:
    """A graph ready to run, with the lengths of its dynamic axes fixed."""
    import onnxruntime

    onnxruntime.disable_telemetry_events()
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = threads
    options.inter_op_num_threads = 1
    # Threads that spin while they wait take the cores from whatever else runs: a busy machine gets half as fast again.
    options.add_session_config_entry("session.intra_op.allow_spinning", "0")
    for axis, length in lengths.items():
        options.add_free_dimension_override_by_name(axis, length)
    names, settings = zip(*provider.execution_providers, strict=True)
    return onnxruntime.InferenceSession(str(path), options, providers=list(names), provider_options=list(settings))
