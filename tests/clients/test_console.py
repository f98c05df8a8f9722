import io

import pytest
import typer
from rich.console import Console

from captra.health import State
from clients import ServiceUnreachableError
from clients.console import LivePoses, PoseLines, errors_for_people, view_for
from tests.clients.test_playback import result


def console(*, terminal: bool) -> tuple[Console, io.StringIO]:
    file = io.StringIO()
    return Console(file=file, force_terminal=terminal, width=100), file


def test_a_terminal_gets_a_table_that_redraws_itself() -> None:
    terminal, file = console(terminal=True)
    with view_for(terminal) as view:
        assert isinstance(view, LivePoses)
        view(result(3, 0.05, State.UNCERTAIN))
    assert "frame 3" in file.getvalue()
    assert "uncertain" in file.getvalue()
    assert "0.050  0.000  0.600" in file.getvalue()


def test_a_pipe_gets_every_tenth_frame_and_every_change_of_state() -> None:
    pipe, file = console(terminal=False)
    with view_for(pipe) as view:
        assert isinstance(view, PoseLines)
        for seq in range(21):
            view(result(seq, 0.05, State.LOST if seq == 13 else State.TRACKING))
    assert [line.split()[1] for line in file.getvalue().splitlines()] == ["0", "10", "13", "14", "20"]
    assert "object at  0.050  0.000  0.600 m" in file.getvalue()


def test_expected_errors_end_a_command_with_their_message(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as ended, errors_for_people():
        raise ServiceUnreachableError("start one")
    assert ended.value.exit_code == 1
    assert capsys.readouterr().err == "captra: start one\n"
