"""The Python client: open a session, stream clouds, receive poses."""

import atexit
import time
from collections import OrderedDict
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, closing, suppress
from dataclasses import replace
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Self

import numpy as np
from jaxtyping import Float

from captra.geometry import Pose
from clients import tracking
from clients.clouds import CloudEncoding, Frame, get_encoding
from clients.errors import NoResultError, ServiceUnreachableError
from clients.inbox import Inbox
from clients.recorder import Recorder, recorder_for
from clients.rest import OpenedSession, RestApi, parts_of, session_body
from clients.results import Event, Result, parse_event, parse_result
from clients.stream import CloudStream

REMEMBERED_FRAMES = 256
"""How many clouds' times of departure are kept to tell round trips."""

Cloud = Float[np.ndarray, "points 3"]


def open_session(
    category: str,
    pose: Pose,
    *,
    url: str | None = None,
    profile: str | None = None,
    frame_id: str | None = None,
    idle_timeout_s: float | None = None,
    encoding: str = "i16",
    record: Path | str | None = None,
    timeout_s: float = 10.0,
) -> "Session":
    """Open a tracking session; use it with `with`, so that it gets closed.

    Args:
        category: what is tracked, e.g. `mug`.
        pose: roughly where every part is in the first cloud: rotation, translation, size; the cloud's frame, metres.
        url: address of the service; without it `CAPTRA_URL`, else http://127.0.0.1:8080.
        profile: `realtime` or `paper`; without it the service's own.
        frame_id: name of the cloud's coordinate frame, carried through to the results.
        idle_timeout_s: the service closes the session after so long without a cloud.
        encoding: `i16` (0.1 mm steps, ±3.27 m, 10,000 points in one Zenoh batch: finer than any depth camera, and half
            the bytes) or `f32`, for scenes that reach further.
        record: file to write everything into that is sent and received, *.mcap; `captra track` replays it.
        timeout_s: the longest wait for an answer by HTTP, and for the connection by Zenoh.

    Raises:
        RequestRefusedError: the service does not accept it; `reason` says why.
        ServiceUnreachableError: no service at the address.
    """
    chosen = get_encoding(encoding)
    options = {"profile": profile, "frame_id": frame_id, "idle_timeout_s": idle_timeout_s}
    with ExitStack() as resources:
        api = resources.enter_context(closing(RestApi(url, timeout_s)))
        recorder = recorder_for(record)
        resources.callback(recorder.close)
        recorder.session(session_body(category, pose, options))
        return Session(api, api.open(category, pose, options), chosen, resources, recorder)


class Session:
    """One tracked object. Puts may come from any thread, results are read by one."""

    def __init__(
        self, api: RestApi, opened: OpenedSession, encoding: CloudEncoding, resources: ExitStack, recorder: Recorder
    ) -> None:
        """Takes over what `resources` holds and closes it when the session is closed."""
        self._api = api
        self._opened = opened
        self._encoding = encoding
        self._recorder = recorder
        self._inbox: Inbox[tracking.Message] = Inbox()
        self._departures: OrderedDict[int, float] = OrderedDict()
        self._lock = Lock()
        self._next_seq = 0
        self._latest: Result | None = None
        self._stream = CloudStream(opened, encoding.media_type, self._take_result, self._take_event)
        resources.callback(self._delete)
        self._stream.open(api.timeout_s)
        resources.callback(self._stream.close)
        atexit.register(self.close)  # Zenoh keeps an interpreter from ending whose sessions are still open
        resources.callback(atexit.unregister, self.close)
        self._resources = resources.pop_all()

    @property
    def session_id(self) -> str:
        """Names the session in the service's REST paths, Zenoh keys, logs and metrics."""
        return self._opened.session_id

    @property
    def category(self) -> str:
        """What is tracked."""
        return self._opened.category

    @property
    def latest(self) -> Result | None:
        """The newest result, whether it was read or not; None before the first."""
        return self._latest

    def put(self, points: Cloud, stamp_ns: int | None = None) -> int:
        """Send a cloud and return at once; the returned number is the `seq` of its result.

        The freshest cloud wins: one that arrives while the service works on another replaces any that waits, so results
        may skip numbers but never lag behind. Keep a cloud under 64 KB (`crop_ball`, `thin_out`) where the network is
        not loopback. Without `stamp_ns` the cloud carries the present time.
        """
        payload = self._encoding.encode(points)
        with self._lock:
            seq = self._number()
            self._departures[seq] = time.perf_counter()
            if len(self._departures) > REMEMBERED_FRAMES:
                self._departures.popitem(last=False)
            stamp_ns = time.time_ns() if stamp_ns is None else stamp_ns
            self._recorder.frame(payload, self._encoding.media_type, seq, stamp_ns, np.reshape(points, (-1, 3)))
            self._stream.put(payload, seq, stamp_ns)
        return seq

    def post(self, points: Cloud, stamp_ns: int | None = None) -> Result:
        """Send a cloud by HTTP and wait for its result: simpler and slower than Zenoh.

        Raises:
            RequestRefusedError: the service could not use the cloud; `reason` says why.
        """
        payload = self._encoding.encode(points)
        with self._lock:
            seq = self._number()
        stamp_ns = time.time_ns() if stamp_ns is None else stamp_ns
        answer = self._api.post_frame(self.session_id, payload, self._encoding.media_type, seq=seq, stamp_ns=stamp_ns)
        return parse_result(answer)

    def receive(self, timeout_s: float = 5.0) -> Result | Event:
        """The next result or event that was not read yet, in the order of arrival.

        Raises:
            NoResultError: nothing came within `timeout_s`.
        """
        while not isinstance(message := self._inbox.get(timeout_s), Result | Event):
            if message is None:
                raise NoResultError(
                    f"nothing came from session {self.session_id} for {timeout_s:g} s: is the service still running, "
                    "and do clouds leave this machine?"
                )
        return message

    def track(
        self,
        clouds: Iterable[Cloud | Frame],
        *,
        rate_hz: float | None = None,
        on_event: Callable[[Event], None] = tracking.raise_rejections,
        timeout_s: float = 5.0,
    ) -> Iterator[Result]:
        """Send clouds and yield the results as they come.

        Without `rate_hz` each cloud is put when the result of the one before is there: every cloud gets its result, as
        fast as the service can. With it clouds are put at that rate whatever the service does, as a camera would; the
        freshest wins, so there may be fewer results than clouds. `Frame(points, stamp_ns)` gives a cloud its stamp.

        Args:
            clouds: point clouds (N, 3) in metres, of any length; may block, like a camera.
            rate_hz: clouds a second.
            on_event: called with every event; by default a rejected cloud raises, pass `lambda event: None` to go on.
            timeout_s: the longest wait for a result.

        Raises:
            FrameRejectedError: the service could not use a cloud; `reason` says why.
            NoResultError: no result within `timeout_s`.
            SessionClosedError: the service closed the session.
        """
        self._inbox.clear()
        line = tracking.Line(self.put, self._inbox, on_event, timeout_s)
        return tracking.in_turn(line, clouds) if rate_hz is None else tracking.at_rate(line, clouds, rate_hz)

    def reset(self, pose: Pose) -> None:
        """Start again from a given pose, e.g. after the track was lost."""
        self._api.reset(self.session_id, pose)
        self._recorder.reset({"parts": parts_of(pose)})

    def close(self) -> None:
        """Close the session, here and in the service; once is enough, more does no harm."""
        self._resources.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _number(self) -> int:
        seq = self._next_seq
        self._next_seq += 1
        return seq

    def _delete(self) -> None:
        with suppress(ServiceUnreachableError):  # a service that is gone holds no session
            self._api.delete(self.session_id)

    def _take_result(self, payload: bytes) -> None:
        arrived = time.perf_counter()
        result = parse_result(payload)
        self._recorder.result(payload, result)
        departed = self._departures.pop(result.seq, None)
        if departed is not None:
            result = replace(result, round_trip_ms=1e3 * (arrived - departed))
        self._latest = result
        self._inbox.put(result)

    def _take_event(self, payload: bytes) -> None:
        self._recorder.event(payload)
        self._inbox.put(parse_event(payload))
