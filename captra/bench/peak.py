"""How fast matrices are multiplied here at best: a chain of large products, run the way the networks are."""

from pathlib import Path
from time import perf_counter

import numpy as np

from captra.runtime.cores import available_cores
from captra.runtime.onnx_networks import open_session
from captra.runtime.providers import choose_provider

GRAPH = "peak.onnx"
"""Beside this module; `benchmarks/write_peak.py` wrote it."""

ROWS, WIDTH, PRODUCTS = 2048, 512, 8
"""Activations and weights stay in the caches."""


def gemm_peak_gflops(provider: str, repetitions: int = 60) -> float:
    """Best of some repetitions on all cores, 10⁹ floating-point operations a second; a multiply-add is two.

    Raises:
        ProviderError: the provider is unknown or not installed.
    """
    import onnxruntime

    threads = available_cores()
    chosen = choose_provider(provider, threads, onnxruntime.get_available_providers())
    session = open_session(Path(__file__).with_name(GRAPH), {}, chosen, threads)
    rows = np.random.default_rng(0).uniform(0, 1, (ROWS, WIDTH)).astype(np.float32)
    durations_s = []
    for _ in range(repetitions):
        started_s = perf_counter()
        session.run(None, {"rows": rows})
        durations_s.append(perf_counter() - started_s)
    return 2 * ROWS * WIDTH * WIDTH * PRODUCTS / min(durations_s) / 1e9
