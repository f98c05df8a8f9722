"""What a bundle scores, as its manifest says it."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from captra.evaluation.summary import Summary
from captra.runtime.bundle import Score, load_manifest, write_manifest

COMMAND = "captra evaluate"


def write_scores(bundle: Path, command: str, means: Mapping[str, Summary]) -> None:
    """Put the means of groups of sequences into a manifest, in the place of what the command printed before.

    Args:
        bundle: folder of the bundle.
        command: prints these numbers.
        means: by the name of the group, e.g. `procedural`.
    """
    manifest = load_manifest(bundle)
    values = {f"{group}_{name}": value for group, mean in means.items() for name, value in figures(mean).items()}
    others = tuple(score for score in manifest.scores if not score.command.startswith(COMMAND))
    write_manifest(bundle, replace(manifest, scores=(*others, Score(command, values))))


def figures(mean: Summary) -> dict[str, float]:
    """The figures of one group; the names hold the units."""
    values = {
        "sequences": mean.sequences,
        "5deg5cm_percent": round(mean.within_5deg_5cm_percent, 1),
        "iou_oriented_percent": round(mean.iou_oriented_percent, 1),
        "iou_nocs_percent": round(mean.iou_nocs_percent, 1),
        "rotation_deg": round(mean.rotation_deg, 2),
        "translation_cm": round(mean.translation_cm, 2),
        "scale_percent": round(mean.scale_percent, 2),
    }
    joints = {"joint_deg": mean.joint_deg, "joint_cm": mean.joint_cm}
    return values | {name: round(value, 2) for name, value in joints.items() if value is not None}


def command_for(category: str, options: Mapping[str, object]) -> str:
    """The command line that repeats a run, `options` by name; placeholders stand for folders outside this one."""
    words = [COMMAND, "--category", category]
    for name, value in options.items():
        words += [f"--{name}", _shown(name, value)]
    return " ".join(words)


def _shown(name: str, value: object) -> str:
    if not isinstance(value, Path):
        return str(value)
    inside = value.resolve().is_relative_to(Path.cwd().resolve())
    return value.as_posix() if inside and not value.is_absolute() else name.upper()
