"""`captra status` against a real service, and against none."""

import pytest
import typer

from clients.status import status
from tests.service.support import blob, f32, running


def test_it_tells_what_can_be_tracked_and_how_sessions_are(capsys: pytest.CaptureFixture[str]) -> None:
    with running("mug") as service:
        assert service.service.readiness.wait_prepared(30)
        url = str(service.http.base_url)
        status(url)
        assert "No session is open" in capsys.readouterr().out
        opened = service.open_session()
        assert service.post_frame(opened["session_id"], f32(blob())).status_code == 200
        assert service.post_frame(opened["session_id"], b"", seq=1).status_code == 422
        status(url)
        shown = capsys.readouterr().out
        for expected in ("is ready", "mug: float32", opened["session_id"], "1 of 2 frames", "1 × empty-cloud"):
            assert expected in " ".join(shown.split()), shown
        status(url, quiet=True)
        assert capsys.readouterr().out == ""


def test_a_service_that_is_not_ready_is_no_success(capsys: pytest.CaptureFixture[str]) -> None:
    with running("mug") as service:
        assert service.service.readiness.wait_prepared(30)
        service.service.readiness.stopping()
        with pytest.raises(typer.Exit) as ended:
            status(str(service.http.base_url), quiet=True)
    assert ended.value.exit_code == 1
    assert "stop" in capsys.readouterr().err


def test_without_a_service_it_says_how_to_start_one(capsys: pytest.CaptureFixture[str]) -> None:
    with running("mug") as service:
        url = str(service.http.base_url)
    with pytest.raises(typer.Exit):
        status(url)
    assert "captra serve" in capsys.readouterr().err
