"""What can be read of a damaged file is kept, whichever way it is damaged."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from captra.data.recordings import RecordingError
from captra.recording.reader import messages, salvage
from captra.recording.writer import SessionWriter

FRAMES, BLOCK = 120, 4096
Damage = Callable[[bytes, int], bytes]


@pytest.fixture(scope="module")
def content(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """A recording of several chunks."""
    path = tmp_path_factory.mktemp("recorded") / "session.mcap"
    writer, rng = SessionWriter(path), np.random.default_rng(0)
    writer.session({"category": "mug"})
    for seq in range(FRAMES):
        points = rng.normal(size=(1000, 3)).astype("<f4")
        writer.frame(seq, seq, "application/vnd.captra.cloud.f32", points.tobytes(), b"", points)
    writer.close()
    return path.read_bytes()


def cut(content: bytes, start: int) -> bytes:
    return content[:start]


def tail_of_zeros(content: bytes, start: int) -> bytes:
    """As a power cut leaves a file whose length was written before its blocks."""
    return content[:start] + bytes(len(content) - start)


def block_of_zeros(content: bytes, start: int) -> bytes:
    return content[:start] + bytes(BLOCK) + content[start + BLOCK :]


def tail_of_noise(content: bytes, start: int) -> bytes:
    return content[:start] + np.random.default_rng(start).bytes(len(content) - start)


@pytest.mark.parametrize("damage", [cut, tail_of_zeros, block_of_zeros, tail_of_noise])
def test_what_comes_before_the_damage_is_kept_and_nothing_else(damage: Damage, content: bytes, tmp_path: Path) -> None:
    path, whole = tmp_path / "session.mcap.part", tmp_path / "session.mcap"
    counts = []
    for start in np.linspace(0.4, 0.9, 24) * len(content):
        path.write_bytes(damage(content, int(start) // BLOCK * BLOCK))
        salvage(path, whole)
        found = list(messages(whole))
        assert found[0] == ("captra.Session", {"category": "mug"})
        assert [body["seq"] for _, body in found[1:]] == list(range(len(found) - 1))
        counts.append(len(found))
    assert counts == sorted(counts)
    assert 1 < counts[0] < counts[-1] < FRAMES


def test_what_is_whole_stays_complete(content: bytes, tmp_path: Path) -> None:
    path, whole = tmp_path / "session.mcap.part", tmp_path / "session.mcap"
    path.write_bytes(content)
    salvage(path, whole)
    assert [body["seq"] for name, body in messages(whole) if name == "captra.Frame"] == list(range(FRAMES))


@pytest.mark.parametrize("rest", [b"", bytes(BLOCK), b"nothing of the kind"])
def test_a_file_of_nothing_is_told(rest: bytes, tmp_path: Path) -> None:
    path = tmp_path / "session.mcap.part"
    path.write_bytes(rest)
    with pytest.raises(RecordingError, match=r"nothing can be read of .*session\.mcap\.part: delete it"):
        salvage(path, tmp_path / "session.mcap")


def test_a_disk_that_is_full_is_no_damage(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "session.mcap.part"
    path.write_bytes(content)
    with pytest.raises(OSError, match="No space left"):
        salvage(path, Path("/dev/full"))
