from collections.abc import Iterator

import pytest
import zenoh

from tests.service.support import Running, running, zenoh_client


@pytest.fixture
def service() -> Iterator[Running]:
    with running() as started:
        assert started.service.readiness.wait_prepared(120)
        yield started


@pytest.fixture
def network(service: Running) -> Iterator[zenoh.Session]:
    with zenoh_client(service.endpoint) as session:
        yield session
