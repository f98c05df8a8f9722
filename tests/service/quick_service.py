"""A service process whose networks follow the middle of a cloud, with sessions in its state folder.

LEASE_MS says after how long without a sign of life its clients give it up.
"""

import os

from service.router import ZenohTransport
from service.run import run
from service.security.wiring import zenoh_entries
from service.settings import Settings
from service.sqlite_store import SqliteSessionStore
from service.tracking_service import TrackingService
from tests.service.support import CentreProvider


def build(settings: Settings) -> TrackingService:
    store = SqliteSessionStore(settings.state_dir / f"{settings.service}.sqlite")
    entries = zenoh_entries(settings) | {"transport/link/tx/lease": int(os.environ.get("LEASE_MS", "10000"))}
    transport = ZenohTransport(settings.service, settings.zenoh_listen, (), settings.max_payload_bytes, entries)
    return TrackingService(settings, CentreProvider("mug"), store, transport)


if __name__ == "__main__":
    run(Settings(), build)
