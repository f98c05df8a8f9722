"""Structured logs: one JSON object a line, on standard error."""

import logging
import sys
import traceback
from datetime import UTC, datetime
from typing import TextIO

import orjson

_STANDARD = frozenset(logging.makeLogRecord({}).__dict__) | {"message", "asctime", "taskName", "color_message"}


class JsonFormatter(logging.Formatter):
    """Time, level, logger, message and whatever was passed as `extra`, e.g. `session_id`."""

    def format(self, record: logging.LogRecord) -> str:
        """One line of JSON."""
        entry: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname.lower(),
            "logger": record.name,
            "message": record.getMessage(),
        }
        entry |= {name: value for name, value in record.__dict__.items() if name not in _STANDARD}
        if record.exc_info:
            entry["exception"] = "".join(traceback.format_exception(*record.exc_info)).rstrip()
        return orjson.dumps(entry, default=str).decode()


def configure_logging(level: str, stream: TextIO = sys.stderr) -> None:
    """Send every logger of the process through the formatter; for the process's entry point alone."""
    handler = logging.StreamHandler(stream)
    handler.setFormatter(JsonFormatter())
    logging.basicConfig(level=level.upper(), handlers=[handler], force=True)
    logging.getLogger("uvicorn").setLevel("WARNING")  # what it tells besides, the service tells itself
    logging.getLogger("python_multipart").setLevel("ERROR")  # what is wrong with a form, its refusal tells
