from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from captra.geometry import Pose
from tests.clients.fake_service import FakeService
from tests.made_up import write_bundle
from tests.service.support import Running, running


@pytest.fixture(scope="module")
def service() -> Iterator[Running]:
    """A real service of one rigid and one articulated category, for all tests of a file.

    It never searches: no confidence trusts what these tests make up, and a search would hold the last trusted pose.
    """
    with running("mug", "laptop_articulated", search_budget_ms=0) as started:
        assert started.service.readiness.wait_prepared(120)
        yield started


@pytest.fixture(scope="module")
def url(service: Running) -> str:
    return str(service.http.base_url)


@pytest.fixture
def fake() -> Iterator[FakeService]:
    with FakeService() as service:
        yield service


@pytest.fixture
def first_pose() -> Pose:
    return Pose.from_size(np.eye(3)[None], np.array([[0.1, 0.2, 0.9]]), np.array([[0.12, 0.09, 0.08]]))


@pytest.fixture(scope="session")
def untrained_models(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A models folder with a mug bundle whose networks have never been trained."""
    folder = tmp_path_factory.mktemp("models")
    write_bundle("mug", folder / "mug")
    return folder
