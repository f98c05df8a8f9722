"""What a file tells of a track: its results in order, and the truth where the file has it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import orjson
from jaxtyping import Float64

from captra import metrics
from captra.categories import get_category
from captra.data.recordings import Recording, RecordingError
from captra.geometry import Pose
from captra.recording.reader import is_mcap, messages
from captra.recording.writer import RESULT, SESSION, TRUTH
from clients.results import Result, parse_result


@dataclass(frozen=True)
class History:
    """One track."""

    results: Sequence[Result]
    """In order."""
    truth: Mapping[int, Pose]
    """By stamp; empty where it is not known."""
    symmetric: bool
    """Whether rotations are compared by their y axes alone."""

    def errors(self) -> tuple[Float64[np.ndarray, "frames parts"], Float64[np.ndarray, "frames parts"]] | None:
        """Rotation (degrees) and translation (cm); NaN for frames whose truth is not known, none where none is."""
        if not any(result.stamp_ns in self.truth for result in self.results):
            return None
        rotations, translations = [], []
        for result in self.results:
            pose, true = result.pose, self.truth.get(result.stamp_ns)
            if true is None or true.num_parts != pose.num_parts:
                unknown = np.full(pose.num_parts, np.nan)
                true_rotation, true_translation = unknown, unknown
            else:
                true_rotation = metrics.rotation_error_deg(pose.rotation, true.rotation, symmetric=self.symmetric)
                true_translation = metrics.translation_error_cm(pose.translation, true.translation)
            rotations.append(true_rotation)
            translations.append(true_translation)
        return np.array(rotations), np.array(translations)


def history_of(path: Path, truth: Recording | None) -> History:
    """The track in a file: an MCAP recording, or results as JSON, in a list or one a line.

    Args:
        path: *.mcap or *.json.
        truth: what was played, for files that do not hold the truth themselves.

    Raises:
        RecordingError: the file holds no results.
    """
    results, known, symmetric = mcap_history(path) if is_mcap(path) else (json_results(path), {}, False)
    if not results:
        raise RecordingError(f"{path} holds no results: record a session with captra record, or captra track --record")
    if truth is not None:
        known = {int(stamp_ns): truth.truth(frame) for frame, stamp_ns in enumerate(truth.stamps_ns)}
        symmetric = truth.category.symmetric
    return History(results, known, symmetric)


def mcap_history(path: Path) -> tuple[list[Result], dict[int, Pose], bool]:
    """Results, truth, and whether the category is symmetric."""
    results, truth, symmetric = list[Result](), dict[int, Pose](), False
    for name, body in messages(path):
        if name == RESULT:
            results.append(parse_result(body))
        elif name == TRUTH:
            truth[body["stamp_ns"]] = pose_of(body["parts"])
        elif name == SESSION:
            symmetric = get_category(body["category"]).symmetric
    return results, truth, symmetric


def json_results(path: Path) -> list[Result]:
    """Results as the service sends them.

    Raises:
        RecordingError: something in the file is none.
    """
    text = path.read_bytes()
    try:
        bodies = orjson.loads(text) if text.lstrip().startswith(b"[") else map(orjson.loads, text.splitlines())
        return [parse_result(body) for body in bodies if body["seq"] is not None]
    except (orjson.JSONDecodeError, KeyError, TypeError, ValueError) as error:
        raise RecordingError(
            f"{path} is no list of results ({error}): give them as they come on the pose key, in a list or one a line"
        ) from error


def pose_of(parts: Sequence[Mapping[str, Any]]) -> Pose:
    """A pose from the form that bodies of the REST API have."""
    return Pose.from_size(
        np.array([part["rotation"]["matrix"] for part in parts]),
        np.array([part["translation"] for part in parts]),
        np.array([part["size"] for part in parts]),
    )
