"""No reason without a test that meets it, nor without a counter."""

from pathlib import Path

import pytest

from service.rejections import FRAME_REASONS, REQUEST_REASONS
from tests.service.support import Running

TESTS = Path(__file__).parent
SOURCES = [path.read_text(encoding="utf-8") for path in TESTS.rglob("test_*.py") if path != Path(__file__)]


@pytest.mark.parametrize("reason", [*FRAME_REASONS, *REQUEST_REASONS])
def test_every_reason_is_met_by_a_test(reason: str) -> None:
    assert any(f'"{reason}"' in source for source in SOURCES)


def test_every_reason_has_a_counter_from_the_start(service: Running) -> None:
    for kind, reasons in (("frames", FRAME_REASONS), ("requests", REQUEST_REASONS)):
        for reason in reasons:
            assert service.metric(f'captra_{kind}_rejected_total{{reason="{reason}"}}') == 0
