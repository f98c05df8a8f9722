"""Sessions in an SQLite file, so that the next process goes on with them, however this one ended."""

import logging
import sqlite3
import threading
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import orjson

from captra.depth_images import Intrinsics
from captra.geometry import Pose
from service.camera import Camera
from service.ros2.options import Ros2Options
from service.store import SessionRecord, StoreError, TrustedPose
from service.track_options import TrackOptions

logger = logging.getLogger(__name__)

SCHEMA_VERSION = 1
SCHEMA = """
CREATE TABLE IF NOT EXISTS sessions (
    session_id TEXT PRIMARY KEY,
    created_ns INTEGER NOT NULL,
    settings BLOB NOT NULL,  -- JSON: the fields of a record but for its pose
    trusted BLOB NOT NULL    -- JSON: the last trusted pose and its frame
) WITHOUT ROWID
"""
POSE_FIELDS = ("rotation", "translation", "scale", "size")
TAKEOVER_WAIT_S = 5.0
"""How long a process waits for the one before it to let go of the file."""


class SqliteSessionStore:
    """One file with one writer: a process that opens it keeps every other one out until it closes it or dies.

    Opening and closing of sessions is written at once; trusted poses are gathered, the newest of each session, and
    written a few times a second, so that no frame waits for a disk.
    """

    def __init__(self, path: Path, flush_every_s: float = 0.1) -> None:
        """Open or create the file.

        Raises:
            StoreError: the folder cannot be written, the file is no store, or another process has it.
        """
        self._flush_every_s = flush_every_s
        self._on_failure: Callable[[], None] = lambda: None
        self._poses_fail = False
        self._pending: dict[str, TrustedPose] = {}
        self._unremoved = set[str]()
        self._lock = threading.Lock()  # of what is pending; never held while the disk works
        self._writing = threading.Lock()
        self._stopped = threading.Event()
        self._connection = connect(path)
        self._thread = threading.Thread(target=self._run, name="captra-store", daemon=True)
        self._thread.start()

    def watch(self, on_failure: Callable[[], None]) -> None:
        """Call this from now on, whenever the file could not be written."""
        self._on_failure = on_failure

    def save(self, record: SessionRecord) -> None:
        """Add or replace a session; it is in the file when this returns.

        Raises:
            StoreError: the file cannot be written.
        """
        row = (record.session_id, record.created_ns, settings_json(record), trusted_json(record.trusted))
        with self._lock:
            self._pending.pop(record.session_id, None)
        try:
            self._write("INSERT OR REPLACE INTO sessions VALUES (?, ?, ?, ?)", [row])
        except sqlite3.Error as error:
            raise StoreError(
                f"the session cannot be stored ({error}): free space in CAPTRA_STATE_DIR, then try again"
            ) from error

    def trust(self, session_id: str, trusted: TrustedPose) -> None:
        """Remember a session's last trusted pose; it is in the file a moment later."""
        with self._lock:
            self._pending[session_id] = trusted

    def remove(self, session_id: str) -> None:
        """Forget a session."""
        with self._lock:
            self._pending.pop(session_id, None)
        try:
            self._delete([session_id])
        except sqlite3.Error:  # it is over all the same, and removed once the disk takes it
            logger.exception("session not removed from the store yet", extra={"session_id": session_id})
            with self._lock:
                self._unremoved.add(session_id)

    def load(self) -> Sequence[SessionRecord]:
        """Every session, oldest first; a row that cannot be read is left where it is."""
        self.flush()
        with self._writing:
            rows = self._connection.execute(
                "SELECT session_id, settings, trusted FROM sessions ORDER BY created_ns"
            ).fetchall()
        records = []
        for session_id, settings, trusted in rows:
            try:
                records.append(record_of(settings, trusted))
            except (TypeError, ValueError, KeyError):
                logger.exception("stored session cannot be read", extra={"session_id": session_id})
        return records

    def flush(self) -> None:
        """Write what is pending; what cannot be written stays pending, unless there is something newer by then."""
        self._remove_belatedly()
        with self._lock:
            pending, self._pending = self._pending, {}
        if not pending:
            return
        rows = [(trusted_json(trusted), session_id) for session_id, trusted in pending.items()]
        try:
            self._write("UPDATE sessions SET trusted = ? WHERE session_id = ?", rows)
        except sqlite3.Error as error:
            if not self._poses_fail:  # once, not ten times a second
                logger.error("trusted poses not stored: %s", error, extra={"session_ids": list(pending)})
            self._poses_fail = True
            with self._lock:
                self._pending = pending | self._pending
        else:
            if self._poses_fail:
                logger.info("trusted poses stored again")
            self._poses_fail = False

    def _remove_belatedly(self) -> None:
        with self._lock:
            unremoved = sorted(self._unremoved)
        if not unremoved:
            return
        try:
            self._delete(unremoved)
        except sqlite3.Error:
            return  # it was told when they were closed
        with self._lock:
            self._unremoved.difference_update(unremoved)
        logger.info("sessions removed from the store", extra={"session_ids": unremoved})

    def close(self) -> None:
        """Write what is pending and let go of the file; once is enough, more does no harm."""
        if self._stopped.is_set():
            return
        self._stopped.set()
        self._thread.join()
        self.flush()
        with self._writing:
            self._connection.close()

    def _delete(self, session_ids: Sequence[str]) -> None:
        self._write("DELETE FROM sessions WHERE session_id = ?", [(session_id,) for session_id in session_ids])

    def _write(self, statement: str, rows: Sequence[tuple[Any, ...]]) -> None:
        try:
            with self._writing, self._connection:
                self._connection.executemany(statement, rows)
        except sqlite3.Error:
            self._on_failure()
            raise

    def _run(self) -> None:
        while not self._stopped.wait(self._flush_every_s):
            self.flush()


def connect(path: Path) -> sqlite3.Connection:
    """The only connection to the file.

    Raises:
        StoreError: the folder cannot be written, the file is no store, or another process has it.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        connection = sqlite3.connect(path, timeout=TAKEOVER_WAIT_S, check_same_thread=False)
    except (OSError, sqlite3.Error) as error:
        raise StoreError(
            f"sessions cannot be kept in {path} ({error}): set CAPTRA_STATE_DIR to a folder that can be written"
        ) from error
    try:
        connection.execute("PRAGMA locking_mode = EXCLUSIVE")  # the lock goes with the process, however that ends
        connection.execute("PRAGMA journal_mode = WAL")
        connection.execute("PRAGMA synchronous = NORMAL")  # what is committed survives the process; no wait for disks
        (version,) = connection.execute("PRAGMA user_version").fetchone()
        if version > SCHEMA_VERSION:
            raise StoreError(f"{path} was written by a newer version of the service: use that, or move the file away")
        with connection:
            connection.execute(SCHEMA)
            connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION}")
    except StoreError:
        connection.close()
        raise
    except sqlite3.Error as error:
        connection.close()
        raise StoreError(explain(path, error)) from error
    return connection


def explain(path: Path, error: sqlite3.Error) -> str:
    """What to do about a file that cannot be opened."""
    if "locked" in str(error):
        return (
            f"another service process keeps its sessions in {path}: stop it, "
            "or give this one another CAPTRA_STATE_DIR or CAPTRA_SERVICE"
        )
    if "full" in str(error):
        return f"sessions cannot be kept in {path} ({error}): free space on its disk, or set another CAPTRA_STATE_DIR"
    return f"sessions cannot be kept in {path} ({error}): move the file away, or set another CAPTRA_STATE_DIR"


def settings_json(record: SessionRecord) -> bytes:
    """All of a record but its pose."""
    fields = asdict(replace(record, trusted=None))  # type: ignore[arg-type]  # arrays are written by trusted_json
    del fields["trusted"]
    return orjson.dumps(fields)


def trusted_json(trusted: TrustedPose) -> bytes:
    """A trusted pose, every number exactly."""
    arrays = {name: getattr(trusted.pose, name).tolist() for name in POSE_FIELDS}
    return orjson.dumps({"seq": trusted.seq, **arrays})


def record_of(settings: bytes, trusted: bytes) -> SessionRecord:
    """A record as it was saved.

    Raises:
        TypeError, ValueError, KeyError: it is none.
    """
    pose = orjson.loads(trusted)
    arrays = {name: np.array(pose[name], np.float64) for name in POSE_FIELDS}
    fields = orjson.loads(settings)
    camera, ros2, options = (fields.pop(name, None) for name in ("camera", "ros2", "options"))
    return SessionRecord(
        **fields,
        camera=None if camera is None else Camera(**camera | {"intrinsics": Intrinsics(**camera["intrinsics"])}),
        ros2=None if ros2 is None else Ros2Options(**ros2),
        trusted=TrustedPose(Pose(**arrays), pose["seq"]),
        options=TrackOptions() if options is None else TrackOptions.from_json(options),
    )
