"""Puts what a tracker found into the words of the wire contract."""

from dataclasses import replace

from captra.categories import Category
from captra.geometry import Pose
from captra.health import State
from captra.joints import joint_values
from captra.tracker import TrackResult
from service.envelopes import NumberedHeader
from service.results import Result, Timing, part_poses
from service.store import SessionRecord


class Reporter:
    """Writes the results of one session; its first one is `given` or `gone_on_with`."""

    def __init__(self, record: SessionRecord, category: Category) -> None:
        self._record = record
        self._category = category

    def given(self, pose: Pose) -> Result:
        """A pose that a client gave, as long as no frame has been tracked from it."""
        return Result(
            session_id=self._record.session_id,
            seq=None,
            stamp_ns=None,
            frame_id=self._record.frame_id,
            state=State.TRACKING,
            confidence=1.0,
            parts=part_poses(pose, self._category),
            joints=joint_values(pose, self._category),
        )

    def gone_on_with(self, pose: Pose) -> Result:
        """The last pose that was trusted before the process changed: where the object is now, no frame has told yet."""
        return replace(self.given(pose), state=State.UNCERTAIN, confidence=0.0)

    def unseen(self, last: Result, header: NumberedHeader, state: State, looks: int) -> Result:
        """A frame that showed nothing near the object: the last poses, which nothing bears out any more."""
        return replace(
            last,
            seq=header.seq,
            stamp_ns=header.stamp_ns,
            frame_id=self._frame_id(header),
            state=state,
            confidence=0.0,
            looks=looks,
            timing_ms=Timing(),
        )

    def tracked(
        self, found: TrackResult, header: NumberedHeader, looks: int, queue_ms: float, total_ms: float
    ) -> Result:
        """What one frame told."""
        timing = found.timing
        return Result(
            session_id=self._record.session_id,
            seq=header.seq,
            stamp_ns=header.stamp_ns,
            frame_id=self._frame_id(header),
            state=found.state,
            confidence=found.confidence,
            parts=part_poses(found.pose, self._category),
            joints=found.joints,
            looks=looks,
            timing_ms=Timing(queue_ms, timing.sample_ms, timing.infer_ms, timing.solve_ms, total_ms),
        )

    def _frame_id(self, header: NumberedHeader) -> str:
        return self._record.frame_id if header.frame_id is None else header.frame_id
