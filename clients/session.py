"""The Python client: open a session, stream clouds, receive poses."""

import atexit
import json
import time
from collections import OrderedDict
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack, closing, suppress
from dataclasses import replace
from operator import index
from pathlib import Path
from threading import Lock
from types import TracebackType
from typing import Self

from captra.geometry import Pose
from clients import tracking
from clients.camera import Camera
from clients.clouds import get_encoding
from clients.errors import NoResultError, RequestRefusedError, ServiceUnreachableError, SessionClosedError
from clients.inbox import Inbox
from clients.options import Axis, MaskValues, Prediction, Ros2, SessionOptions, Smoothing
from clients.packing import Frame, Observation, Packer
from clients.recorder import Recorder, recorder_for
from clients.regions import Region
from clients.rest import OpenedSession, RestApi, parts_of, session_body
from clients.results import Event, Result, parse_event, parse_result
from clients.stream import CloudStream

STOPS = "shutdown"
"""Why a session closes that is there again once the service is."""
REMEMBERED_FRAMES = 256
"""How many clouds' times of departure are kept to tell round trips."""


def open_session(
    category: str,
    pose: Pose,
    *,
    url: str | None = None,
    profile: str | None = None,
    frame_id: str | None = None,
    idle_timeout_s: float | None = None,
    encoding: str = "i16",
    camera: Camera | None = None,
    masks: MaskValues | None = None,
    prediction: Prediction | None = None,
    smoothing: Smoothing | None = None,
    joint_axes: Mapping[str, Axis] | None = None,
    ros2: Ros2 | None = None,
    record: Path | str | Recorder | None = None,
    record_in_service: bool = False,
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
        camera: where depth images are sent, the camera that takes them; poses are then in its optical frame.
        masks: where frames bring a `Mask` or `Box`, what a mask's values mean: `object` (zero is background) or `parts`
            (k is part k of the category).
        prediction: where the object is expected in the next frame: where it was (`none`), or where its velocity carries
            it (`constant-velocity`); without it the service's own choice.
        smoothing: filters published poses, so that an object at rest does not tremble; tracking itself is not changed.
        joint_axes: keeps parts on their joints: axis by joint in the parent part's frame, (3,); joints that are not
            named have the category's axes, so `{}` is enough. Without it the model decides.
        ros2: names in ROS 2, of a service that is a node there.
        record: file to write everything into that is sent and received, *.mcap; `captra track` replays it. One that is
            there is replaced once the session is open.
        record_in_service: the service records the session: every frame that it reads, from wherever it comes. The file
            is `<category>_<session_id>` at `GET /v1/recordings`.
        timeout_s: the longest wait for an answer by HTTP, and for the connection by Zenoh.

    Raises:
        RequestRefusedError: the service does not accept it; `reason` says why.
        ServiceUnreachableError: no service at the address.
        RecordingError: `record` cannot be written, or is not called *.mcap.
        ValueError: an argument is not of its kind; the message says what to give.
    """
    if isinstance(record, bool):
        raise ValueError("record is the file to write: the service records with record_in_service=True")
    for name, value, kind in (("camera", camera, Camera), ("smoothing", smoothing, Smoothing), ("ros2", ros2, Ros2)):
        if not isinstance(value, kind | None):
            raise ValueError(f"{name} is a clients.{kind.__name__}(...), not {type(value).__name__}")
    packer = Packer(get_encoding(encoding), camera, masks)
    options = SessionOptions(
        profile=profile,
        frame_id=frame_id,
        idle_timeout_s=idle_timeout_s,
        camera=camera,
        masks=masks,
        prediction=prediction,
        smoothing=smoothing,
        joint_axes=joint_axes,
        record=record_in_service or None,
        ros2=ros2,
    ).body()
    with ExitStack() as resources:
        api = resources.enter_context(closing(RestApi(url, timeout_s)))
        recorder = recorder_for(record) if isinstance(record, Path | str | None) else record
        resources.callback(recorder.close)
        recorder.session(session_body(category, pose, options))
        return Session(api, api.open(category, pose, options), packer, resources, recorder)


class Session:
    """One tracked object. Puts may come from any thread, results are read by one."""

    def __init__(
        self, api: RestApi, opened: OpenedSession, packer: Packer, resources: ExitStack, recorder: Recorder
    ) -> None:
        """Takes over what `resources` holds and closes it when the session is closed."""
        self._api = api
        self._opened = opened
        self._packer = packer
        self._recorder = recorder
        self._inbox: Inbox[tracking.Message] = Inbox()
        self._departures: OrderedDict[int, float] = OrderedDict()
        self._posted: dict[int, bool] = {}  # numbers of frames sent by HTTP, and whether their result is recorded
        self._lock = Lock()
        self._next_seq = 0
        self._latest: Result | None = None
        self._ended = ""
        self._stream = CloudStream(opened, self._take_result, self._take_event)
        resources.callback(self._delete)
        self._stream.open(api.timeout_s)
        resources.callback(self._stream.close)
        api.wait_for_client(opened.session_id)  # or the first result may go by behind a router that knows nothing yet
        recorder.keep()
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

    def put(self, observation: Observation, stamp_ns: int | None = None, mask: Region | None = None) -> int:
        """Send a cloud or an image and return at once; the returned number is the `seq` of its result.

        The freshest wins: one that arrives while the service works on another replaces any that waits, so results may
        skip numbers but never lag behind. Keep a cloud under 64 KB (`crop_ball`, `thin_out`) where the network is
        not loopback. Without `stamp_ns` it carries the present time; a PointCloud2 has its own.

        Raises:
            ValueError: this cannot be sent in this session; the message says what to change.
            SessionClosedError: the session is closed.
        """
        packed = self._packer.pack(observation, mask)
        with self._lock:
            self._check_open()
            seq = self._number()
            self._departures[seq] = time.perf_counter()
            if len(self._departures) > REMEMBERED_FRAMES:
                self._departures.popitem(last=False)
            stamp_ns = time.time_ns() if stamp_ns is None else index(stamp_ns)  # also of an array
            self._recorder.frame(packed, seq, stamp_ns)
            self._stream.put(packed, seq, stamp_ns)
        return seq

    def post(self, observation: Observation, stamp_ns: int | None = None, mask: Region | None = None) -> Result:
        """Send a cloud or an image by HTTP and wait for its result: simpler and slower than Zenoh.

        Raises:
            ValueError: this cannot be sent in this session; the message says what to change.
            RequestRefusedError: the service could not use it; `reason` says why.
            SessionClosedError: the session is closed.
        """
        packed = self._packer.pack(observation, mask)
        stamp_ns = time.time_ns() if stamp_ns is None else index(stamp_ns)  # also of an array
        with self._lock:
            self._check_open()
            seq = self._number()
            self._posted[seq] = False
            self._recorder.frame(packed, seq, stamp_ns)
        try:
            answer = self._api.post_frame(
                self.session_id, packed.payload, packed.media_type, seq=seq, stamp_ns=stamp_ns, region=packed.region
            )
        except RequestRefusedError:
            self._posted.pop(seq, None)
            raise
        result = parse_result(answer)
        self._record(json.dumps(answer).encode(), result)
        return result

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
        observations: Iterable[Observation | Frame],
        *,
        rate_hz: float | None = None,
        on_event: Callable[[Event], None] | None = None,
        timeout_s: float = 5.0,
    ) -> Iterator[Result]:
        """Send clouds or images and yield the results as they come.

        Without `rate_hz` each is put when the result of the one before is there: every one gets its result, as fast as
        the service can. With it they are put at that rate whatever the service does, as a camera would; the freshest
        wins, so there may be fewer results. `Frame(cloud, stamp_ns, mask)` gives one its stamp and its mask.

        Args:
            observations: point clouds (N, 3) in metres, of any length, or whatever `put` takes; may block, like a
                camera.
            rate_hz: how many a second.
            on_event: called with every event but rejections of clouds sent before; by default a rejected cloud raises
                (pass `lambda event: None` to go on), unless it just shows nothing of an object that was tracked before.
            timeout_s: the longest wait for a result.

        Raises:
            ValueError: one cannot be sent in this session; the message says what to change.
            FrameRejectedError: the service could not use one; `reason` says why.
            NoResultError: no result within `timeout_s`.
            SessionClosedError: the session is closed.
        """
        self._check_open()
        self._inbox.clear()
        line = tracking.Line(self.put, self._inbox, on_event or self._raise_rejection, timeout_s, self._next_seq)
        if rate_hz is None:
            return tracking.in_turn(line, observations)
        return tracking.at_rate(line, observations, rate_hz)

    def reset(self, pose: Pose) -> None:
        """Start again from a given pose, e.g. after the track was lost."""
        self._api.reset(self.session_id, pose)
        self._recorder.reset({"parts": parts_of(pose)})

    def close(self) -> None:
        """Close the session, here and in the service; once is enough, more does no harm."""
        self._ended = self._ended or "this client closed it"
        self._resources.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _raise_rejection(self, event: Event) -> None:
        """Go on where an object that was tracked is out of sight: whoever reads hears of it when it is lost."""
        if self._latest is None or event.reason not in tracking.UNSEEN:
            tracking.raise_rejections(event)

    def _number(self) -> int:
        seq = self._next_seq
        self._next_seq += 1
        return seq

    def _check_open(self) -> None:
        if self._ended:
            raise SessionClosedError(f"session {self.session_id} is closed ({self._ended}): open a new one")

    def _delete(self) -> None:
        with suppress(ServiceUnreachableError):  # a service that is gone holds no session
            self._api.delete(self.session_id)

    def _take_result(self, payload: bytes) -> None:
        arrived = time.perf_counter()
        result = parse_result(payload)
        self._record(payload, result)
        departed = self._departures.pop(result.seq, None)
        if departed is not None:
            result = replace(result, round_trip_ms=1e3 * (arrived - departed))
        self._latest = result
        self._inbox.put(result)

    def _record(self, payload: bytes, result: Result) -> None:
        """Record a result; that of a frame sent by HTTP comes twice, as the answer and by Zenoh."""
        with self._lock:
            recorded = self._posted.pop(result.seq, None)
            if recorded is False:
                self._posted[result.seq] = True
        if not recorded:
            self._recorder.result(payload, result)

    def _take_event(self, payload: bytes) -> None:
        self._recorder.event(payload)
        event = parse_event(payload)
        if event.kind == "closing" and event.reason != STOPS:
            self._ended = event.detail
        self._inbox.put(event)
