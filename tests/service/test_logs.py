import io
import json
import logging
from collections.abc import Iterator

import pytest

from service.logs import JsonFormatter


@pytest.fixture
def log() -> Iterator[tuple[logging.Logger, io.StringIO]]:
    stream = io.StringIO()
    handler = logging.StreamHandler(stream)
    handler.setFormatter(JsonFormatter())
    logger = logging.getLogger("captra.test")
    logger.addHandler(handler)
    logger.setLevel("INFO")
    yield logger, stream
    logger.removeHandler(handler)


def test_entry_is_one_line_with_what_was_passed_along(log: tuple[logging.Logger, io.StringIO]) -> None:
    logger, stream = log
    logger.info("session\n%s", "opened", extra={"session_id": "f00", "odd": object})
    line = stream.getvalue()
    assert line.count("\n") == 1
    entry = json.loads(line)
    assert (entry["level"], entry["logger"], entry["message"]) == ("info", "captra.test", "session\nopened")
    assert entry["session_id"] == "f00"
    assert set(entry) == {"time", "level", "logger", "message", "session_id", "odd"}


def test_exceptions_are_told(log: tuple[logging.Logger, io.StringIO]) -> None:
    logger, stream = log
    try:
        raise ValueError("broken")
    except ValueError:
        logger.exception("failed")
    assert "ValueError: broken" in json.loads(stream.getvalue())["exception"]
