"""Compilation of the numeric kernels, cached on disk wherever a disk can be written."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def compiled(function: Kernel) -> Kernel:
    """Compile a kernel with numba: it releases the GIL, and its machine code is kept for the next start.

    On a file system that cannot be written anywhere the kernel is compiled in memory instead, at warm-up.
    """
    return _compiled(function)


def compiled_without_nan(function: Kernel) -> Kernel:
    """As `compiled`, for kernels that never see NaN: their minima and maxima are vectorized; results stay the same."""
    return _compiled(function, fastmath={"nnan", "nsz"})


def _compiled(function: Kernel, **options: Any) -> Kernel:
    try:
        kernel = numba.njit(nogil=True, cache=True, **options)(function)
    except RuntimeError:  # numba found no folder it may write its cache to
        kernel = numba.njit(nogil=True, **options)(function)
    return kernel  # type: ignore[no-any-return]
