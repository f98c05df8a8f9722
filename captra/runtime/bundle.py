"""A bundle: a folder with both networks of one category and the manifest that says what they are."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from types import MappingProxyType
from typing import Any

from captra.errors import UserError
from captra.joint_projection import JOINT_PROJECTIONS
from captra.mirrors import MIRRORS
from captra.rotation_fusion import ROTATION_FUSIONS
from captra.sampling import PROFILES, InputSampling, Profile

MANIFEST = "manifest.json"
COORDINATE = "coordinate.onnx"
ROTATION = "rotation.onnx"
FORMAT = 1
"""Raised when older readers could misunderstand a manifest."""
CHOICES: Mapping[str, Mapping[str, object]] = MappingProxyType(
    {"joint_projection": JOINT_PROJECTIONS, "rotation_fusion": ROTATION_FUSIONS, "mirror": MIRRORS}
)
"""Entries of a manifest that are one of several names."""


class BundleError(UserError, ValueError):
    """A bundle that is damaged, incomplete or of another version; the message says what to do."""


@dataclass(frozen=True)
class MeshCredit:
    """A mesh that training used."""

    name: str
    """As its library calls it."""
    license: str
    """Its licence."""
    attribution: str
    """Whom the licence asks to be named."""


@dataclass(frozen=True)
class Training:
    """Where the weights come from."""

    data: str
    """What the networks saw."""
    steps: int
    """Optimizer steps of CoordinateNet; `details` tell of RotationNet."""
    seed: int | None = None
    """Of its data and weights, where there was one."""
    commit: str = ""
    """Of the source that trained it."""
    meshes: tuple[MeshCredit, ...] = ()
    """Everything whose licence asks for attribution."""
    details: Mapping[str, Any] = field(default_factory=dict)
    """Whatever else helps to train them again."""


@dataclass(frozen=True)
class Score:
    """What the exported networks score."""

    command: str
    """Prints these numbers."""
    values: Mapping[str, float]
    """Number by name; the name holds the unit."""


@dataclass(frozen=True)
class Manifest:
    """What a bundle's manifest.json says."""

    category: str
    """Name of the category."""
    parts: tuple[str, ...]
    """Part names in the order of the networks' outputs."""
    symmetric: bool
    """Whether RotationNet gives the direction of the y axis only."""
    precision: str
    """How the weights are stored; CoordinateNet's and RotationNet's where they differ, e.g. int6 and int8."""
    opset: int
    """Of both graphs."""
    sha256: Mapping[str, str]
    """Digest of each file of the bundle."""
    training: Training
    """Where the weights come from."""
    scores: tuple[Score, ...] = ()
    """What they score, as exported."""
    profiles: Mapping[str, Profile] = field(default_factory=lambda: dict(PROFILES))
    """Shapes that they were made for; the graphs accept others."""
    rotation_share: float = 1.0
    """Share of the points, the first ones, that RotationNet answers for; older manifests do not say it and mean all."""
    rotation_input: str = "crop"
    """Points that RotationNet reads: `crop`, the same as CoordinateNet."""
    input_sampling: InputSampling = field(default_factory=InputSampling)
    """How points are drawn from the crop."""
    rotation_fusion: str = "rotation-net"
    """Whose word counts for rotations: a name of `captra.rotation_fusion.ROTATION_FUSIONS`."""
    joint_projection: str = "free"
    """How rotations are kept on the joints: a name of `captra.joint_projection.JOINT_PROJECTIONS`; older manifests do
    not say it and leave every part free."""
    mirror: str = "none"
    """Whether CoordinateNet is asked about the mirrored cloud as well: a name of `captra.mirrors.MIRRORS`; older
    manifests do not say it and ask once."""
    found_error: Mapping[str, Any] = field(default_factory=dict)
    """By how much the networks err on one object all the time, as `captra.pose_memory.FoundError.measured` reads it;
    older manifests do not say it."""
    health: Mapping[str, Any] = field(default_factory=dict)
    """Calibration of the confidence on these networks, as `captra.health.HealthMonitor.calibrated` reads it."""
    format: int = FORMAT
    """Version of this file's layout."""

    def to_json(self) -> str:
        """As written to disk."""
        return json.dumps(asdict(self), indent=2, ensure_ascii=False, allow_nan=False) + "\n"

    @classmethod
    def from_json(cls, text: str) -> "Manifest":
        """The inverse of `to_json`.

        Raises:
            BundleError: it is no manifest, or one of another version.
        """
        try:
            content = json.loads(text)
            if content["format"] != FORMAT:
                raise BundleError(f"its format is {content['format']}, this version reads {FORMAT}: {_ADVICE}")
            content["training"]["meshes"] = tuple(MeshCredit(**mesh) for mesh in content["training"]["meshes"])
            content["training"] = Training(**content["training"])
            content["scores"] = tuple(Score(**score) for score in content["scores"])
            content["profiles"] = {name: _profile(shape) for name, shape in content["profiles"].items()}
            content["input_sampling"] = InputSampling(**content["input_sampling"])
            content["parts"] = tuple(content["parts"])
            content["sha256"] = dict(content["sha256"])
            content.setdefault("rotation_share", 1.0)
            content.setdefault("joint_projection", "free")
            content.setdefault("mirror", "none")
            content.setdefault("found_error", {})
            if not 0 < content["rotation_share"] <= 1:
                raise BundleError(f"its rotation share {content['rotation_share']} is none: {_ADVICE}")
            for name, known in CHOICES.items():
                if content[name] not in known:
                    raise BundleError(f"its {name.replace('_', ' ')} {content[name]!r} is unknown: {_ADVICE}")
            if missing := [entry.name for entry in fields(cls) if entry.name not in content]:
                raise BundleError(f"it lacks {', '.join(missing)}: {_ADVICE}")
            return cls(**content)
        except (json.JSONDecodeError, KeyError, TypeError, AttributeError, ValueError) as error:
            if isinstance(error, BundleError):
                raise
            raise BundleError(f"it is no manifest of this version ({error!r}): {_ADVICE}") from error


_ADVICE = "export the bundle again with `captra export`, or update captra"


def _profile(shape: Mapping[str, Any]) -> Profile:
    first, second = shape["groups"]
    return Profile(shape["name"], shape["points"], tuple(shape["centroids"]), (tuple(first), tuple(second)))


def load_manifest(folder: Path) -> Manifest:
    """Read a bundle's manifest, without looking at the networks.

    Raises:
        BundleError: there is none, or it cannot be understood.
    """
    path = folder / MANIFEST
    try:
        return Manifest.from_json(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise BundleError(f"{folder} is no bundle: it has no {MANIFEST}; write one with `captra export`") from None
    except BundleError as error:
        raise BundleError(f"{path} cannot be read: {error}") from error


def verify(folder: Path, manifest: Manifest) -> None:
    """Compare every file of a bundle with its digest.

    Raises:
        BundleError: a file is missing or differs.
    """
    for name in (COORDINATE, ROTATION):
        path, expected = folder / name, manifest.sha256.get(name, "")
        if not path.is_file():
            raise BundleError(f"{path} is missing: copy the whole bundle again, or export it again")
        if (found := sha256_of(path)) != expected:
            raise BundleError(
                f"{path} is damaged or was replaced: its sha256 is {found[:12]}…, the manifest says {expected[:12]}…; "
                "copy the whole bundle again, or export it again"
            )


def sha256_of(path: Path) -> str:
    """Digest of a file, in hexadecimal."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write_manifest(folder: Path, manifest: Manifest) -> None:
    """Write a bundle's manifest, all at once."""
    partial = folder / f"{MANIFEST}.partial"
    partial.write_text(manifest.to_json(), encoding="utf-8")
    partial.replace(folder / MANIFEST)


def find_bundles(models_dir: Path) -> dict[str, Path]:
    """Bundles in a model repository by category: its folders that have a manifest, each called like its category.

    Raises:
        FileNotFoundError: there is no such folder.
    """
    return {path.parent.name: path.parent for path in sorted(models_dir.glob(f"*/{MANIFEST}"))}
