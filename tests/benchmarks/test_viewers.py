"""Viewers of the benchmark see what a page would see."""

import time

from benchmarks.viewers import watched
from tests.service.support import f32, running
from tests.service.viewer.looking import scene


def test_every_viewer_gets_the_clouds_of_the_newest_session() -> None:
    with running("mug") as service:
        assert service.service.readiness.wait_prepared(120)
        with watched(str(service.http.base_url), 2) as seen:
            session_id = service.open_session()["session_id"]
            for seq in range(30):
                assert service.post_frame(session_id, f32(scene()), seq=seq).status_code == 200
                time.sleep(0.1)
        assert len(seen) == 2
        for one in seen:
            assert one.clouds > 1
            assert one.points == one.clouds * len(scene())
            assert one.seconds > 0
