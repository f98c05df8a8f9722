import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from captra.categories import CATEGORIES
from captra.looking import Networks
from service.networks import LoadedOnce
from tests.service.support import CentreNetworks


def test_many_who_ask_at_once_share_one_load() -> None:
    loads: list[tuple[str, str]] = []
    everyone = threading.Barrier(8)

    def load(category: str, profile: str) -> Networks:
        loads.append((category, profile))
        return CentreNetworks(CATEGORIES[category])

    shared = LoadedOnce(load)

    def ask() -> Networks:
        everyone.wait()
        return shared.get("mug", "realtime")

    with ThreadPoolExecutor(8) as pool:
        answers = [future.result() for future in [pool.submit(ask) for _ in range(8)]]
    assert loads == [("mug", "realtime")]
    assert all(answer is answers[0] for answer in answers)
    assert shared.get("mug", "paper") is not answers[0]
    assert list(shared.loaded("mug")) == ["realtime", "paper"]
    assert shared.loaded("bottle") == {}


def test_failed_load_is_told_and_tried_again() -> None:
    attempts = iter([RuntimeError("disk"), None])

    def load(category: str, profile: str) -> Networks:
        error = next(attempts)
        if error is not None:
            raise error
        return CentreNetworks(CATEGORIES[category])

    shared = LoadedOnce(load)
    with pytest.raises(RuntimeError, match="disk"):
        shared.get("mug", "realtime")
    assert shared.get("mug", "realtime").category.name == "mug"
