"""Clouds need the secret of their session."""

import hashlib
from collections.abc import Iterator

import numpy as np
import pytest
import zenoh

from captra.geometry import Pose
from clients import open_session
from service.envelopes import pack_attachment
from service.rejections import WrongSecretError
from service.security.secrets import SecretHolders, admission_of
from service.store import InMemorySessionStore
from tests.service.support import Camera, Running, blob, f32, inbox, running, zenoh_client


@pytest.fixture
def guarded() -> Iterator[Running]:
    with running("mug", cloud_secrets=True) as started:
        assert started.service.readiness.wait_prepared(60)
        yield started


def test_secret_is_taken_off_the_attachment() -> None:
    secret = bytes(range(16))
    holders = SecretHolders(hashlib.sha256(secret).hexdigest())
    assert holders.admit(b"header" + secret) == b"header"
    assert holders.admit(secret) is None
    for wrong in (None, b"", b"header", secret[:-1], secret + b"x", secret[::-1]):
        with pytest.raises(WrongSecretError):
            holders.admit(wrong)
    assert admission_of(None).admit(b"header") == b"header"


def test_strangers_cannot_move_a_session_and_its_client_can(guarded: Running) -> None:
    pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
    with open_session("mug", pose, url=str(guarded.http.base_url)) as session, zenoh_client(guarded.endpoint) as other:
        shown = guarded.session(session.session_id)
        assert shown["zenoh"]["secret"] is None
        events = inbox(other, shown["zenoh"]["event"])
        stranger = Camera(other, shown["zenoh"]["cloud"])
        for index, attachment in enumerate((pack_attachment(5, 0), pack_attachment(5, 0) + bytes(16), None)):
            stranger.put(f32(blob((0.05, 0, 0.5))), attachment=attachment)
            assert events.message(index)["reason"] == "wrong-secret"
        (result,) = session.track([blob((0.01, 0, 0.5))], on_event=lambda event: None)
        assert result.parts[0].translation[0] == pytest.approx(0.01, abs=2e-3)
        assert guarded.session(session.session_id)["counters"]["processed"] == 1
        assert guarded.metric('captra_frames_rejected_total{reason="wrong-secret"}') >= 1


def test_secret_survives_the_process_and_is_never_stored_itself() -> None:
    store = InMemorySessionStore()
    with running("mug", cloud_secrets=True, store=store) as first:
        opened = first.open_session()
    secret = bytes.fromhex(opened["zenoh"]["secret"])
    assert store.load()[0].secret_sha256 == hashlib.sha256(secret).hexdigest()
    with running("mug", cloud_secrets=True, store=store) as second, zenoh_client(second.endpoint) as network:
        assert second.service.readiness.wait_prepared(60)
        poses = inbox(network, opened["zenoh"]["pose"])
        camera = Camera(network, opened["zenoh"]["cloud"])
        camera.put(f32(blob()), attachment=pack_attachment(3, 0) + secret)
        assert poses.message(0)["seq"] == 3
        assert isinstance(network, zenoh.Session)
