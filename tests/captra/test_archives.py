from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from captra.archives import ArchiveError, read_arrays


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_bits_that_flipped_are_one_kind_of_error(save: Callable[..., None], tmp_path: Path) -> None:
    path = tmp_path / "arrays.npz"
    save(path, points=np.arange(12.0).reshape(4, 3), category=np.array("mug"))
    whole, rng = path.read_bytes(), np.random.default_rng(0)
    assert read_arrays(path)["points"].shape == (4, 3)
    refused = 0
    for at in range(len(whole)):
        flipped = bytearray(whole)
        flipped[at] ^= 1 << int(rng.integers(8))
        path.write_bytes(flipped)
        try:
            read_arrays(path)
        except ArchiveError:
            refused += 1
    assert refused > len(whole) / 2


def test_a_file_that_is_not_there_is_no_damaged_one(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        read_arrays(tmp_path / "none.npz")
