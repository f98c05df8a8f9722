"""Clouds that no camera sends: random bytes, and proper frames with something broken, from a seed."""

import struct
from collections.abc import Iterator

import numpy as np

from service.codecs import CLOUD_F32, CLOUD_I16
from service.envelopes import Envelope, pack_attachment

NOT_NUMBERS = np.array([np.nan, np.inf, -np.inf, 3e38, -3e38, 1e7], "<f4")
ODD_ENCODINGS = (
    "",
    "image/png",
    "application/cdr",
    "application/json",
    "text/plain;a=b",
    "\ud7ff/\u00e9",
    "a" * 10_000,
)


def malformed_clouds(seed: int) -> Iterator[Envelope]:
    """Endlessly many; some of them happen to be well formed, none holds the object at (0, 0, 0.5) m."""
    rng = np.random.default_rng(seed)
    breakers = (random_bytes, torn, poisoned, oddly_encoded, oddly_attached, elsewhere)
    while True:
        yield breakers[int(rng.integers(len(breakers)))](rng)


def cloud(rng: np.random.Generator) -> np.ndarray:
    """A proper cloud, far from the object."""
    return rng.uniform(20, 30, (int(rng.integers(1, 200)), 3)).astype("<f4")


def attachment(rng: np.random.Generator) -> bytes:
    """A proper attachment with any numbers."""
    return pack_attachment(int(rng.integers(2**63)), int(rng.integers(-(2**63), 2**63 - 1)))


def random_bytes(rng: np.random.Generator) -> Envelope:
    """Anything at all."""
    encoding = (CLOUD_F32, CLOUD_I16, "application/cdr", "image/png")[int(rng.integers(4))]
    return Envelope(encoding, rng.bytes(int(rng.integers(0, 600))), attachment(rng), 0.0)


def torn(rng: np.random.Generator) -> Envelope:
    """Cut off within a point."""
    payload = cloud(rng).tobytes()
    return Envelope(CLOUD_F32, payload[: -int(rng.integers(1, 12))], attachment(rng), 0.0)


def poisoned(rng: np.random.Generator) -> Envelope:
    """Numbers that are none, or too large."""
    points = cloud(rng)
    points.flat[rng.integers(points.size, size=3)] = rng.choice(NOT_NUMBERS, 3)
    return Envelope(CLOUD_F32, points.tobytes(), attachment(rng), 0.0)


def oddly_encoded(rng: np.random.Generator) -> Envelope:
    """A cloud under a name that it does not have."""
    return Envelope(ODD_ENCODINGS[int(rng.integers(len(ODD_ENCODINGS)))], cloud(rng).tobytes(), attachment(rng), 0.0)


def oddly_attached(rng: np.random.Generator) -> Envelope:
    """Without number and stamp, or with half of them."""
    odd = (None, b"", struct.pack("<Q", 1), rng.bytes(17), rng.bytes(300))
    return Envelope(CLOUD_F32, cloud(rng).tobytes(), odd[int(rng.integers(len(odd)))], 0.0)


def elsewhere(rng: np.random.Generator) -> Envelope:
    """Well formed, but without the object."""
    return Envelope(CLOUD_F32, cloud(rng).tobytes(), attachment(rng), 0.0)
