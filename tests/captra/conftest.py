"""Oracles learn where they are asked to look."""

from typing import Any

import pytest

from captra import tracker
from captra.looking import Sighting, look
from tests.oracle import OracleNetworks


@pytest.fixture(autouse=True)
def oracles_know_where_a_tracker_looks(monkeypatch: pytest.MonkeyPatch) -> None:
    """A tracker looks around poses of its own choice, and more than once where one was given."""

    def told(networks: Any, observation: Any, around: Any, *others: Any) -> Sighting:
        if isinstance(networks, OracleNetworks):
            networks.last = around
        return look(networks, observation, around, *others)

    monkeypatch.setattr(tracker, "look", told)
