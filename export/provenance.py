"""What a manifest says about where weights come from, read from the checkpoints themselves."""

from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from captra.learn.checkpoint import is_authors, training_info
from captra.learn.plan import NetworkName, Plan
from captra.runtime.bundle import MeshCredit, Training
from captra.sampling import InputSampling

AUTHORS_DATA = "the authors' released checkpoints: synthetic data of the paper (NOCS-CAMERA, SAPIEN)"
OWN_DATA = "procedural shapes in simulated scenes, seen by a simulated depth camera"
TOLD_ELSEWHERE = ("meshes", "input_sampling", "rotation_fusion")
"""Entries of checkpoints that manifests keep outside of the details of training."""
BATCH_SIZE = 12
"""Samples a step of checkpoints that do not say."""


def training_of(coordinate: Path, rotation: Path) -> Training:
    """What both checkpoints say of their training.

    Raises:
        CheckpointError: one of them is no checkpoint.
    """
    coordinate_info, rotation_info = training_info(coordinate), training_info(rotation)
    details: dict[str, Any] = {"coordinate": coordinate_info, "rotation": rotation_info}
    return Training(
        data=AUTHORS_DATA if is_authors(coordinate) else str(coordinate_info.get("data", OWN_DATA)),
        steps=_steps(coordinate_info),
        seed=coordinate_info.get("seed"),
        commit=str(coordinate_info.get("commit", "")),
        meshes=tuple(MeshCredit(**mesh) for mesh in coordinate_info.get("meshes", ())),
        details={name: _without(info, *TOLD_ELSEWHERE) for name, info in details.items()},
    )


def with_network(training: Training, name: NetworkName, checkpoint: Path) -> Training:
    """One network as it was, and what the checkpoint of the other says of its training.

    Raises:
        CheckpointError: it is no checkpoint.
    """
    info = training_info(checkpoint)
    meshes = (*training.meshes, *(MeshCredit(**mesh) for mesh in info.get("meshes", ())))
    if name == "coordinate":
        training = replace(training, steps=_steps(info), commit=str(info.get("commit", "")), seed=info.get("seed"))
    return replace(
        training,
        meshes=tuple({mesh.name: mesh for mesh in meshes}.values()),
        details={**training.details, name: _without(info, *TOLD_ELSEWHERE)},
    )


def input_sampling_of(coordinate: Path) -> InputSampling:
    """How the points of training were drawn; uniformly unless the checkpoint says otherwise, as in the paper.

    Raises:
        CheckpointError: it is no checkpoint.
    """
    return InputSampling(**{**asdict(InputSampling()), **training_info(coordinate).get("input_sampling", {})})


def rotation_fusion_of(coordinate: Path) -> str:
    """Whose word counts for rotations: RotationNet's alone unless the checkpoint says otherwise, as in the paper.

    Raises:
        CheckpointError: it is no checkpoint.
    """
    return str(training_info(coordinate).get("rotation_fusion", "rotation-net"))


def rotation_share_of(rotation: Path) -> float:
    """Share of the points that the heads saw in training: all in the authors', in ours what the plan says.

    Raises:
        CheckpointError: it is no checkpoint.
    """
    return 1.0 if is_authors(rotation) else float(training_info(rotation).get("rotation_share", Plan().rotation_share))


def _steps(info: dict[str, Any]) -> int:
    if "steps" in info:
        return int(info["steps"])
    return int(info.get("iteration", int(info.get("samples", 0)) // int(info.get("batch_size", BATCH_SIZE))))


def _without(info: dict[str, Any], *names: str) -> dict[str, Any]:
    return {name: value for name, value in info.items() if name not in names}
