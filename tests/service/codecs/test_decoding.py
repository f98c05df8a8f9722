"""Bytes of strangers: whatever they are, they are decoded or refused, and nothing else is raised."""

import gc
from collections import Counter

import numpy as np
import pytest

from benchmarks.decoding import Decoder, decoder, seeds
from service.rejections import FRAME_REASONS, REQUEST_REASONS

MUTATIONS = 4000


@pytest.fixture(scope="module")
def decode() -> Decoder:
    return decoder()


def test_well_formed_inputs_of_every_kind_are_decoded(decode: Decoder) -> None:
    decoded = {seed[0] for seed in seeds() if decode.decode(seed) is None}
    assert decoded == set(range(7))


def test_what_is_left_of_them_after_any_damage_is_decoded_or_refused(decode: Decoder) -> None:
    rng, whole, reasons = np.random.default_rng(11), list(seeds()), Counter[str | None]()
    for _ in range(MUTATIONS):
        data = bytearray(whole[rng.integers(len(whole))])
        for _ in range(rng.integers(1, 6)):
            at = int(rng.integers(len(data)))
            match rng.integers(4):
                case 0:
                    data[at] = rng.integers(256)
                case 1:
                    del data[at : at + int(rng.integers(1, 40))]
                case 2:
                    data[at:at] = rng.bytes(int(rng.integers(1, 40)))
                case _:
                    data[at : at + 4] = [b"\xff\xff\xff\xff", b"\0\0\0\0", b"\0\0\0\x80"][rng.integers(3)]
            data = data or bytearray(1)
        reasons[decode.decode(bytes(data))] += 1
    gc.collect()  # files left open would be told of as errors
    assert set(reasons) <= {None, *FRAME_REASONS, *REQUEST_REASONS}
    assert len(reasons) >= 10
    assert reasons[None] > MUTATIONS / 20
