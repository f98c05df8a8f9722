"""Bytes of strangers: whatever they are, they are decoded or refused, and nothing else is raised."""

import gc
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from benchmarks.decoding import ENCODINGS, Decoder, decoder, seeds
from service.rejections import FRAME_REASONS, REQUEST_REASONS

MUTATIONS = 4000
EXAMPLES = 500
WHOLE = list(seeds())
REFUSALS = {None, *FRAME_REASONS, *REQUEST_REASONS} - {"internal-error"}


@pytest.fixture(scope="module")
def decode() -> Decoder:
    return decoder()


def test_well_formed_inputs_of_every_kind_are_decoded(decode: Decoder) -> None:
    decoded = {seed[0] for seed in WHOLE if decode.decode(seed) is None}
    assert decoded == set(range(7))


def test_what_is_left_of_them_after_any_damage_is_decoded_or_refused(decode: Decoder) -> None:
    rng, reasons = np.random.default_rng(11), Counter[str | None]()
    for _ in range(MUTATIONS):
        data = bytearray(WHOLE[rng.integers(len(WHOLE))])
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
    assert set(reasons) <= REFUSALS
    assert len(reasons) >= 10
    assert reasons[None] > MUTATIONS / 20


@settings(max_examples=EXAMPLES, deadline=None)
@given(kind=st.integers(0, len(ENCODINGS) - 1), attachment=st.binary(max_size=255), payload=st.binary(max_size=800))
def test_any_bytes_in_any_encoding_are_decoded_or_refused(
    decode: Decoder, kind: int, attachment: bytes, payload: bytes
) -> None:
    assert decode.decode(bytes([kind, len(attachment)]) + attachment + payload) in REFUSALS


@settings(max_examples=EXAMPLES, deadline=None)
@given(whole=st.sampled_from(WHOLE), place=st.floats(0, 1), put=st.binary(max_size=8), taken=st.integers(0, 40))
def test_well_formed_inputs_with_a_hole_or_a_graft_are_decoded_or_refused(
    decode: Decoder, whole: bytes, place: float, put: bytes, taken: int
) -> None:
    at = int(place * len(whole))
    assert decode.decode(whole[:at] + put + whole[at + taken :]) in REFUSALS
