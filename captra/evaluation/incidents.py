"""Recordings in which something goes wrong: derived from others by editing their clouds and their order.

Everything happens in the camera frame, x right, y down, z forward. What an occluder or the edge of the image takes away
is what a camera would not see; the surroundings are those that the recording holds, a ball around the object.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from jaxtyping import Bool, Float, Float32, Float64, UInt8

from captra.data.recordings import Recording
from captra.geometry import axis_angle
from captra.perturbation import random_direction

LEAD = 10
"""Frames before anything happens."""

GAP_FRAMES = 10
"""Frames that are missing after the sensor paused."""

RAMP = 5
"""Frames in which an occluder or the edge of the image moves over the object."""

BOARD_NOISE_M = 0.0015
"""Standard deviation of the depth of an occluder."""

LEAST_POINTS, LEAST_SHARE = 20, 0.03
"""An object with fewer points, or with a smaller share of those that it had at first, is not in the cloud."""

KEPT_SHARE = 0.85
"""Share of a frame's points that is drawn anew whenever the frame is shown again."""


@dataclass(frozen=True)
class Span:
    """How long something takes."""

    fault: int
    """Frames for which an object is out of sight."""
    after: int
    """Frames after it, as far as there are any: time to be found again."""


FULL = Span(30, 25)
"""What recovery is judged by."""

BRIEF = Span(12, 12)
"""Enough to be lost, searched for and found again: for fitting, where more of the same says little more."""


@dataclass(frozen=True)
class Incident:
    """A recording in which something goes wrong once."""

    kind: str
    """A key of `INCIDENTS`."""
    recording: Recording
    """What the sensor delivers, and where the object really is."""
    seen: Bool[np.ndarray, " frames"]
    """Whether the object is in the cloud."""
    start: int
    """First frame that is not as it should be."""
    stop: int
    """First frame that is as it should be again."""


@dataclass(frozen=True)
class _Frame:
    """One cloud and where the object is in it, as in `Recording`."""

    points: Float32[np.ndarray, "N 3"]
    labels: UInt8[np.ndarray, " N"]
    rotation: Float32[np.ndarray, "P 3 3"]
    translation: Float32[np.ndarray, "P 3"]
    joint_values: Float32[np.ndarray, " J"]

    def only(self, kept: Bool[np.ndarray, " N"]) -> "_Frame":
        return replace(self, points=self.points[kept], labels=self.labels[kept])

    def moved(
        self, rotation: Float64[np.ndarray, "3 3"], about: Float[np.ndarray, "3"], shift: Float[np.ndarray, "3"]
    ) -> "_Frame":
        """Everything turned about a point, then shifted: what the camera sees after it was jolted."""

        def map_points(points: np.ndarray) -> np.ndarray:
            return np.asarray((points - about) @ rotation.T + about + shift, np.float32)

        return replace(
            self,
            points=map_points(self.points),
            rotation=(rotation @ self.rotation).astype(np.float32),
            translation=map_points(self.translation),
        )


@dataclass(frozen=True)
class _Film:
    """A recording to be cut."""

    source: Recording
    rng: np.random.Generator
    span: Span

    def frame(self, index: int) -> _Frame:
        s = self.source
        return _Frame(s.clouds[index], s.labels[index], s.rotation[index], s.translation[index], s.joint_values[index])

    def frames(self, start: int, stop: int) -> list[_Frame]:
        return [self.frame(index) for index in range(start, min(stop, len(self.source)))]

    def shown_again(self, index: int, times: int) -> list[_Frame]:
        """A frame as if it were taken so many times more."""
        frame = self.frame(index)
        return [frame.only(self.rng.random(len(frame.points)) < KEPT_SHARE) for _ in range(times)]

    def jolt(
        self, frame: _Frame, reach_m: tuple[float, float], turn_deg: tuple[float, float]
    ) -> Callable[[_Frame], _Frame]:
        """A motion of all that the camera sees by a length and an angle drawn from these ranges."""
        shift = self.rng.uniform(*reach_m) * random_direction(self.rng)
        turn = axis_angle(random_direction(self.rng), np.radians(self.rng.uniform(*turn_deg)))
        about = frame.translation.mean(axis=0)
        return lambda other: other.moved(turn, about, shift)

    def occluder(self, frame: _Frame, gap_m: float) -> Callable[[_Frame, float], _Frame]:
        """A board that stands so far in front of the object and, at progress 1, hides it altogether."""
        own = frame.points[frame.labels < self.source.category.num_parts]
        directions = own[:, :2] / own[:, 2:]
        middle = (directions.min(axis=0) + directions.max(axis=0)) / 2
        reach = 1.2 * float(np.linalg.norm(directions - middle, axis=1).max()) + 0.01
        depth = max(float(own[:, 2].min()) - gap_m, 0.1)

        def covered(other: _Frame, progress: float) -> _Frame:
            offset = other.points[:, :2] / other.points[:, 2:] - middle
            behind = other.points[:, 2] > depth
            hidden = behind & (np.linalg.norm(offset, axis=1) < reach) & (offset[:, 0] < reach * (2 * progress - 1))
            if not self.source.category.background:
                return other.only(~hidden)
            noise = self.rng.normal(scale=BOARD_NOISE_M, size=(len(other.points), 1))
            on_board = other.points * ((depth + noise) / other.points[:, 2:])
            return replace(
                other,
                points=np.where(hidden[:, None], on_board, other.points).astype(np.float32),
                labels=np.where(hidden, np.uint8(self.source.category.num_parts), other.labels),
            )

        return covered

    def incident(self, kind: str, frames: list[_Frame], start: int, stop: int) -> Incident:
        parts, period_ns = self.source.category.num_parts, int(np.median(np.diff(self.source.stamps_ns)))
        own = np.array([np.count_nonzero(frame.labels < parts) for frame in frames])
        seen = own >= max(LEAST_POINTS, LEAST_SHARE * np.median(own[:LEAD]))
        recording = replace(
            self.source,
            name=f"{self.source.name}__{kind}",
            stamps_ns=self.source.stamps_ns[0] + np.arange(len(frames)) * period_ns,
            clouds=tuple(frame.points for frame in frames),
            labels=tuple(frame.labels for frame in frames),
            rotation=np.stack([frame.rotation for frame in frames]),
            translation=np.stack([frame.translation for frame in frames]),
            joint_values=np.stack([frame.joint_values for frame in frames]),
        )
        return Incident(kind, recording, seen, start, stop)


def nothing(film: _Film) -> Incident:
    """All goes well."""
    frames = film.frames(0, LEAD + film.span.fault)
    return film.incident("nothing", frames, len(frames), len(frames))


def occlusion(film: _Film) -> Incident:
    """A board hides the object, which stays put, and goes away again."""
    return _occluded(film, "occlusion", lambda frame: frame)


def occlusion_moved(film: _Film) -> Incident:
    """A board hides the object, which is elsewhere when it goes away: up to 10 cm and 20°."""
    return _occluded(film, "occlusion, moved", film.jolt(film.frame(LEAD), (0.0, 0.10), (0.0, 20.0)))


def removed(film: _Film) -> Incident:
    """The object is taken away and put back, and what is around it stays in sight."""
    own = film.source.category.num_parts
    during = [frame.only(frame.labels >= own) for frame in film.shown_again(LEAD, film.span.fault)]
    frames = film.frames(0, LEAD) + during + film.frames(LEAD, LEAD + film.span.after)
    return film.incident("removed", frames, LEAD, LEAD + film.span.fault)


def left_view(film: _Film) -> Incident:
    """The camera pans until the object is out of its image, waits, and pans back."""
    frame, half = film.frame(LEAD), film.span.fault // 2
    own = frame.points[frame.labels < film.source.category.num_parts]
    edge = float((own[:, 0] / own[:, 2]).max()) + 0.005
    width = edge - float((own[:, 0] / own[:, 2]).min()) + 0.02
    ramp = np.clip(np.r_[np.arange(1, half + 1), np.arange(half - 1, -1, -1)] / (half - RAMP), 0, 1)
    during = []
    for shown, progress in zip(film.shown_again(LEAD, len(ramp)), ramp, strict=True):
        shifted = shown.moved(np.eye(3), np.zeros(3), np.array([progress * width * own[:, 2].max(), 0, 0]))
        during.append(shifted.only(shifted.points[:, 0] / shifted.points[:, 2] < edge))
    frames = film.frames(0, LEAD) + during + film.frames(LEAD, LEAD + film.span.after)
    return film.incident("left view", frames, LEAD, LEAD + len(ramp))


def teleport(film: _Film) -> Incident:
    """From one frame to the next everything is elsewhere: 10 to 25 cm and 20 to 60°."""
    jolt = film.jolt(film.frame(LEAD), (0.10, 0.25), (20.0, 60.0))
    frames = film.frames(0, LEAD) + [jolt(frame) for frame in film.frames(LEAD, LEAD + film.span.after)]
    return film.incident("teleport", frames, LEAD, LEAD)


def wrong_start(film: _Film) -> Incident:
    """The first pose is off: 3 to 10 cm and 20 to 60°."""
    wrong = film.jolt(film.frame(0), (0.03, 0.10), (20.0, 60.0))
    frames = film.frames(0, LEAD + film.span.fault)
    told = film.source.init
    given = wrong(replace(frames[0], rotation=told.rotation, translation=told.translation))
    source = replace(film.source, init=replace(told, rotation=given.rotation, translation=given.translation))
    return replace(film, source=source).incident("wrong start", frames, 0, 0)


def drop_out(film: _Film) -> Incident:
    """The sensor delivers next to nothing for a while: one point in a hundred, anywhere in the ball."""
    during = [
        frame.only(film.rng.random(len(frame.points)) < 0.01) for frame in film.shown_again(LEAD, film.span.fault // 2)
    ]
    frames = film.frames(0, LEAD) + during + film.frames(LEAD, LEAD + film.span.after)
    return film.incident("drop-out", frames, LEAD, LEAD + len(during))


def gap(film: _Film) -> Incident:
    """A third of a second is missing: the object moves on unseen."""
    missing = GAP_FRAMES
    frames = film.frames(0, LEAD) + film.frames(LEAD + missing, LEAD + missing + film.span.after)
    return film.incident("gap", frames, LEAD, LEAD)


def _occluded(film: _Film, kind: str, then: Callable[[_Frame], _Frame]) -> Incident:
    covered = film.occluder(film.frame(LEAD), gap_m=float(np.exp(film.rng.uniform(np.log(0.02), np.log(0.25)))))
    progress = np.minimum(1.0, np.arange(1, RAMP + film.span.fault + 1) / RAMP)
    shown = film.shown_again(LEAD, len(progress))
    during = [covered(frame, float(share)) for frame, share in zip(shown, progress, strict=True)]
    back = [then(frame) for frame in film.frames(LEAD, LEAD + film.span.after)]
    start = LEAD + RAMP - 1
    return film.incident(kind, film.frames(0, LEAD) + during + back, start, start + film.span.fault + 1)


INCIDENTS: Mapping[str, Callable[[_Film], Incident]] = MappingProxyType(
    {
        "nothing": nothing,
        "occlusion": occlusion,
        "occlusion, moved": occlusion_moved,
        "removed": removed,
        "left view": left_view,
        "teleport": teleport,
        "drop-out": drop_out,
        "gap": gap,
        "wrong start": wrong_start,
    }
)
"""What can go wrong, by name."""

LONGEST = LEAD + GAP_FRAMES + FULL.after
"""Frames of a recording that incidents use; shorter ones leave less of what comes after."""


def make_incident(kind: str, recording: Recording, seed: int, span: Span = FULL) -> Incident:
    """Let something go wrong in a recording; the same arguments give the same incident.

    Raises:
        KeyError: `kind` is none of `INCIDENTS`.
        ValueError: the recording is too short.
    """
    if len(recording) <= LEAD + GAP_FRAMES:
        raise ValueError(f"{recording.name} has {len(recording)} frames: more than {LEAD + GAP_FRAMES} are needed")
    return INCIDENTS[kind](_Film(recording, np.random.default_rng([seed, *kind.encode()]), span))
