"""Everything that decodes bytes of strangers, behind one function that takes any bytes at all."""

import io
from collections.abc import Coroutine, Iterator
from dataclasses import dataclass

import numpy as np
from PIL import Image

from captra.categories import get_category
from captra.depth_images import Intrinsics
from captra.geometry import Pose
from captra.observations import Observation
from service.camera import Camera
from service.codecs import CLOUD_F32, CLOUD_I16, DEPTH_F32, DEPTH_PNG, DEPTH_U16, Codecs, build_codecs
from service.codecs.masks import BOX
from service.envelopes import Envelope, pack_attachment
from service.rejections import RejectedError
from service.rest.forms import MULTIPART, SentFrame, frame_of
from service.ros2.attachments import RmwAttachment
from service.ros2.messages import POINT_CLOUD2, serialize, type_store

WIDTH, HEIGHT = 8, 6
ENCODINGS = (CLOUD_F32, CLOUD_I16, "application/cdr", DEPTH_PNG, DEPTH_U16, DEPTH_F32, MULTIPART + "; boundary=b")
"""By the first byte of an input."""
NEAR = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))


@dataclass(frozen=True)
class Decoder:
    """What stands between a stranger and a tracker."""

    codecs: Codecs
    """Of a session with a camera and masks: it reads everything."""

    def decode(self, data: bytes) -> str | None:
        """Decode as a session would: encoding, attachment behind its length, payload; the reason of a refusal.

        Raises whatever is not a refusal: that is a defect.
        """
        kind, length = (data + b"\0\0")[:2]
        encoding = ENCODINGS[kind % len(ENCODINGS)]
        attachment, payload = data[2 : 2 + length], data[2 + length :]
        try:
            if encoding.startswith(MULTIPART):
                sent = at_once(frame_of(payload, encoding, None))
                encoding, payload, attachment = sent.encoding, sent.payload, attachment + sent.mask
            frame, mask = self.codecs.open(Envelope(encoding, payload, attachment or None, 0.0))
            observation = frame.observe()
            self.codecs.segmentation(mask, observation)
            look_at(observation)
        except RejectedError as rejection:
            return rejection.reason
        return None


def decoder() -> Decoder:
    """With small limits, so that those are met too."""
    camera = Camera(Intrinsics(10.0, 10.0, WIDTH / 2, HEIGHT / 2), 0.001, WIDTH, HEIGHT)
    return Decoder(build_codecs(500, 2**16, get_category("mug"), camera, "object"))


def look_at(observation: Observation) -> None:
    """Touch the points, as a crop does."""
    observation.near(NEAR.translation[0], 0.2)


def at_once(coroutine: Coroutine[object, None, SentFrame]) -> SentFrame:
    """The answer of a coroutine that never really waits."""
    try:
        coroutine.send(None)
    except StopIteration as stop:
        answer: SentFrame = stop.value
        return answer
    raise RuntimeError("it waits")


def seeds() -> Iterator[bytes]:
    """Well-formed inputs of every kind: from them mutations get far."""
    ours, rmw = pack_attachment(1, 2), RmwAttachment(1, 2, bytes(16)).pack()
    points = np.random.default_rng(0).uniform(0.45, 0.55, (20, 3)).astype("<f4")
    depth = np.full((HEIGHT, WIDTH), 500, np.uint16)
    mask, box = png(np.ones((HEIGHT, WIDTH), np.uint8)), BOX.pack(1, 1, 5, 5)
    payloads = (
        points.tobytes(),
        (1e4 * points).astype("<i2").tobytes(),
        ros_cloud(points),
        png(depth),
        depth.astype("<u2").tobytes(),
        (1e-3 * depth).astype("<f4").tobytes(),
        form({"cloud": (DEPTH_PNG, png(depth)), "mask": (DEPTH_PNG, mask)}),
    )
    for kind, payload in enumerate(payloads):
        for attachment in (ours, ours + mask, ours + box, rmw, b""):
            yield bytes([kind, len(attachment)]) + attachment + payload


def png(pixels: np.ndarray) -> bytes:
    """An image as PNG."""
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    return file.getvalue()


def form(files: dict[str, tuple[str, bytes]]) -> bytes:
    """A body of files with their media types, separated by `--b`."""
    parts = [
        f'--b\r\nContent-Disposition: form-data; name="{name}"; filename="f"\r\nContent-Type: {kind}\r\n\r\n'.encode()
        + content
        + b"\r\n"
        for name, (kind, content) in files.items()
    ]
    return b"".join(parts) + b"--b--\r\n"


def ros_cloud(points: np.ndarray) -> bytes:
    """A PointCloud2 in CDR."""
    types = type_store().types
    field = types["sensor_msgs/msg/PointField"]
    stamp = types["builtin_interfaces/msg/Time"](sec=1, nanosec=2)
    message = types[POINT_CLOUD2](
        header=types["std_msgs/msg/Header"](stamp=stamp, frame_id="camera"),
        height=1,
        width=len(points),
        fields=[field(name=axis, offset=4 * index, datatype=7, count=1) for index, axis in enumerate("xyz")],
        is_bigendian=False,
        point_step=12,
        row_step=12 * len(points),
        data=np.frombuffer(points.tobytes(), np.uint8),
        is_dense=True,
    )
    return serialize(message, POINT_CLOUD2)
