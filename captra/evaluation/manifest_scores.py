"""What a bundle scores, as its manifest says it."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from captra.evaluation.summary import Summary
from captra.runtime.bundle import Score, load_manifest, write_manifest

COMMAND = "captra evaluate"

REFERENCE = "cpu"
"""The provider that scores are of where their command names none."""


def write_scores(bundle: Path, command: str, means: Mapping[str, Summary]) -> None:
    """Put the means of groups of sequences into a manifest, in the place of what the command printed before.

    Scores by another provider stay beside them: what lower precision costs is read off the two.

    Args:
        bundle: folder of the bundle.
        command: prints these numbers.
        means: by the name of the group, e.g. `procedural`.
    """
    manifest = load_manifest(bundle)
    values = {f"{group}_{name}": value for group, mean in means.items() for name, value in figures(mean).items()}
    replaced = _provider_of(command)
    others = tuple(
        score
        for score in manifest.scores
        if not score.command.startswith(COMMAND) or _provider_of(score.command) != replaced
    )
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


def _provider_of(command: str) -> str:
    """What the command names, or the reference, which it takes by default."""
    words = command.split()
    return words[words.index("--provider") + 1] if "--provider" in words else REFERENCE


def _shown(name: str, value: object) -> str:
    if not isinstance(value, Path):
        return str(value)
    inside = value.resolve().is_relative_to(Path.cwd().resolve())
    return value.as_posix() if inside and not value.is_absolute() else name.upper()
