"""Sessions are reached through the routers of deploy/, which connect to the one inside the service."""

import json
from pathlib import Path

import numpy as np
import pytest
import zenoh

from captra.geometry import Pose
from clients import open_session
from tests.service.support import blob, free_endpoint, running

FOLDER = Path(__file__).parents[2] / "deploy" / "zenoh"


@pytest.mark.parametrize("name", ["router.json5", "robot.json5"])
def test_poses_come_through_the_router(name: str) -> None:
    inner, outer = free_endpoint(), free_endpoint()
    config = zenoh.Config.from_file(str(FOLDER / name))
    config.insert_json5("listen/endpoints", json.dumps([outer]))
    config.insert_json5("connect/endpoints", json.dumps([inner]))
    pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
    with zenoh.open(config), running("mug", endpoint=inner, zenoh_advertise=(outer,)) as service:
        assert service.service.readiness.wait_prepared(30)
        with open_session("mug", pose, url=str(service.http.base_url)) as session:
            # At a camera's rate, since the first results may go by before the service's router knows who listens.
            results = list(session.track([blob()] * 20, rate_hz=10))
    assert results[-1].seq == 19


def test_a_router_waits_for_a_service_that_is_not_there_yet() -> None:
    config = zenoh.Config.from_file(str(FOLDER / "router.json5"))
    config.insert_json5("listen/endpoints", json.dumps([free_endpoint()]))
    config.insert_json5("connect/endpoints", json.dumps([free_endpoint()]))
    with zenoh.open(config) as router:
        assert list(router.info.routers_zid()) == []
