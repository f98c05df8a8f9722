"""What a viewer looks at: a session or a preview, whose news go into its outbox."""

from typing import Protocol

import orjson

from captra.observations import Observation
from service.codecs import Codecs
from service.envelopes import Envelope, NumberedHeader
from service.rejections import RejectedError
from service.results import Event, Result
from service.session import Session
from service.viewer.clouds import Frame
from service.viewer.outbox import Outbox
from service.viewer.previews import Previews


class Watch(Protocol):
    """Something that is looked at until it is ended."""

    def end(self) -> None:
        """Look away."""


class NothingWatched:
    """The viewer looks at nothing."""

    def end(self) -> None:
        """Nothing to do."""


class SessionWatch:
    """Observes a session for one viewer: clouds go with the result they led to."""

    def __init__(self, session: Session, outbox: Outbox) -> None:
        self._session = session
        self._outbox = outbox
        self._scene = f"session/{session.session_id}"
        self._seen: Observation | None = None
        self.result(session.last_result)
        session.observe(self)

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:  # noqa: ARG002
        """Keep it until its result is there."""
        self._seen = observation

    def result(self, result: Result) -> None:
        """Show it."""
        self._outbox.put_message(orjson.dumps({"type": "result", "result": result}))
        self._show(result)

    def event(self, event: Event) -> None:
        """Tell of it."""
        self._outbox.put_message(orjson.dumps({"type": "event", "event": event}))
        self._show(None)

    def end(self) -> None:
        """Look away."""
        self._session.unobserve(self)

    def _show(self, result: Result | None) -> None:
        seen, self._seen = self._seen, None
        if seen is not None:
            self._outbox.put_cloud(lambda: Frame(self._scene, seen.whole().points, result))


class PreviewWatch:
    """Shows what is put on one preview to one viewer."""

    def __init__(self, name: str, previews: Previews, codecs: Codecs, outbox: Outbox) -> None:
        self._name = name
        self._previews = previews
        self._codecs = codecs
        self._outbox = outbox
        previews.listen(name, self._take)

    def end(self) -> None:
        """Look away."""
        self._previews.unlisten(self._name, self._take)

    def _take(self, envelope: Envelope) -> None:
        self._outbox.put_cloud(lambda: self._decoded(envelope))

    def _decoded(self, envelope: Envelope) -> Frame | None:
        try:
            self._codecs.check_size(len(envelope.payload))
            points = self._codecs.find(envelope.encoding).open(envelope).observe().whole().points
        except RejectedError as rejection:
            self._outbox.put_message(orjson.dumps({"type": "refused", "detail": rejection.detail}))
            return None
        return Frame(f"preview/{self._name}", points)
