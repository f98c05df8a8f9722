"""What is read of files whose writer closed them, died, or whose disk did not keep them."""

from pathlib import Path

import numpy as np
import pytest

from captra.data.recordings import RecordingError
from captra.recording.reader import MAGIC, messages
from captra.recording.writer import SessionWriter

FRAMES = 30
CHUNK_BYTES = 1 << 20
"""What MCAP's writer compresses at a time."""


@pytest.fixture(scope="module")
def content(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """A file of several chunks."""
    path = tmp_path_factory.mktemp("recording") / "whole.mcap"
    writer = SessionWriter(path)
    writer.session({"category": "mug"})
    noise = np.random.default_rng(0).normal(size=(FRAMES, 3000, 3)).astype("<f4")
    for seq, points in enumerate(noise):
        writer.frame(seq, seq, "x", points.tobytes(), b"", points)
    writer.close()
    read = path.read_bytes()
    assert len(read) > 2 * CHUNK_BYTES
    return read


def seqs_in(content: bytes, path: Path) -> list[int]:
    path.write_bytes(content)
    return [body["seq"] for name, body in messages(path) if name == "captra.Frame"]


def test_a_file_whose_writer_died_is_read_to_where_it_ends(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "died.mcap"
    counts = []
    for share in (0.5, 0.6, 0.8, 1.0):
        seqs = seqs_in(content[: int(share * len(content)) - 1], path)
        assert seqs == list(range(len(seqs)))
        counts.append(len(seqs))
    assert counts == sorted(counts)
    assert counts[0] > 0
    assert counts[-1] == FRAMES, "all but the last byte is there"


@pytest.mark.parametrize("length", [0, 4, len(MAGIC), 40, 2000, CHUNK_BYTES // 2])
def test_a_file_that_ends_before_its_first_message_is_refused(content: bytes, tmp_path: Path, length: int) -> None:
    path = tmp_path / "early.mcap"
    with pytest.raises(RecordingError, match=r"early\.mcap is no whole MCAP recording .*record it again"):
        seqs_in(content[:length], path)


def test_bits_that_flipped_are_no_traceback(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "flipped.mcap"
    rng = np.random.default_rng(0)
    near_an_end = [*range(len(MAGIC), 400, 3), *range(len(content) - 400, len(content), 3)]
    refused = 0
    for at in [*near_an_end, *rng.integers(0, len(content), 40).tolist()]:
        flipped = bytearray(content)
        flipped[at] ^= 1 << int(rng.integers(8))
        try:
            seqs_in(bytes(flipped), path)
        except RecordingError:
            refused += 1
    assert refused > 0
