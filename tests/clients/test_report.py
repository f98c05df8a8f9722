import io
from dataclasses import replace

import numpy as np
import pytest
from rich.console import Console

from captra.health import State
from clients import Event
from clients.playback import Playback
from clients.report import advice, failure, means_of, percentiles, table_of
from tests.clients.test_playback import perfect, playback, result

TURNED_20_DEG = (0.0, float(np.sin(np.radians(10))), 0.0, float(np.cos(np.radians(10))))


def text_of(played: Playback) -> dict[str, str]:
    """The table's values by measure."""
    console = Console(file=io.StringIO(), width=120)
    console.print(table_of(played))
    lines = console.file.getvalue().splitlines()  # type: ignore[attr-defined]
    cells = [[cell.strip() for cell in line.strip("│┃").split("│")] for line in lines if "│" in line]
    return dict(cells)


def test_a_perfect_track_has_no_errors() -> None:
    table = text_of(playback(perfect()))
    assert table["frames sent / answered"] == "8 / 8"
    assert table["state at the end"] == "tracking (confidence 0.90)"
    assert table["frames by state"] == "8 tracking"
    assert table["rotation error, mean / worst"] == "0.0° / 0.0°"
    assert table["translation error, mean / worst"] == "0.00 cm / 0.00 cm"
    assert table["5°5cm"] == "100.0 %"
    assert table["IoU, oriented / NOCS"] == "1.000 / 1.000"
    assert table["frames per second"] == "16.0"
    assert table["latency put → pose, p50 / p95 / p99"] == "7.0 / 7.0 / 7.0 ms"
    assert table["of which in the service"] == "6.0 / 6.0 / 6.0 ms"


def test_errors_states_and_rejections_show() -> None:
    results = [*perfect()[:-2], result(7, 0.09 + 0.08, State.LOST, TURNED_20_DEG)]
    rejection = Event("s", "rejected", 6, State.TRACKING, "no-points-near-object", "nothing is near")
    table = text_of(playback(results, (rejection,)))
    assert table["frames sent / answered"] == "8 / 7"
    assert table["frames rejected"] == "1"
    assert table["frames by state"] == "6 tracking, 1 lost"
    assert table["translation error, mean / worst"].endswith("/ 8.00 cm")
    assert table["5°5cm"] == f"{100 * 6 / 7:.1f} %"


def test_a_mug_without_visible_handle_is_scored_as_symmetric_and_said_to_be() -> None:
    results = [*perfect()[:-1], result(7, 0.09, quat_xyzw=TURNED_20_DEG)]
    table = text_of(playback(results))
    assert table["frames whose yaw cannot be seen"] == "7 (scored as symmetric)"
    assert table["rotation error, mean / worst"] == "0.0° / 0.0°"


def test_nothing_answered_still_gives_a_table() -> None:
    assert text_of(playback([]))["frames sent / answered"] == "8 / 0"


def test_percentiles_are_of_the_values() -> None:
    assert percentiles(list(range(101))) == "50.0 / 95.0 / 99.0 ms"


def test_a_good_track_held() -> None:
    assert failure(playback(perfect())) is None


def test_it_did_not_hold_without_results() -> None:
    assert failure(playback([])) == "not one frame was answered"


def test_it_did_not_hold_when_a_frame_was_lost_on_the_way() -> None:
    results = perfect()
    results[4] = replace(results[4], state=State.LOST)
    assert failure(playback(results)) == "the service called 1 of 8 frames lost"


def test_it_did_not_hold_when_the_end_is_uncertain() -> None:
    results = perfect()
    results[-1] = replace(results[-1], state=State.UNCERTAIN)
    assert failure(playback(results)) == "the last frame is uncertain"


@pytest.mark.parametrize(
    ("last", "told"),
    [
        (result(7, 0.09 + 0.06), "off by 0.0° and 6.0 cm"),
        (result(7, 0.09, quat_xyzw=(float(np.sin(np.radians(10))), 0, 0, float(np.cos(np.radians(10))))), "20.0° and"),
    ],
)
def test_it_did_not_hold_when_the_service_is_sure_of_a_wrong_pose(last: object, told: str) -> None:
    reason = failure(playback([*perfect()[:-1], last]))  # type: ignore[list-item]
    assert reason is not None
    assert told in reason


def test_it_did_not_hold_when_the_results_stopped_early() -> None:
    reason = failure(playback(perfect()[:2]))
    assert reason is not None
    assert "6.0 cm" in reason


def test_several_recordings_end_with_their_mean() -> None:
    table = means_of([playback(perfect()), playback(perfect())])
    assert table.row_count == 3
    assert list(table.columns[0].cells)[-1] == "all: mean of 2 recordings"
    assert list(table.columns[1].cells) == ["100.0"] * 3


def test_a_service_that_does_not_keep_up_is_told_of() -> None:
    assert advice(playback(perfect())) is None
    told = advice(playback(perfect()[:3]))
    assert told is not None
    assert told.startswith("Only 3 of 8 frames were answered")
    assert "--as-fast-as-possible" in told
