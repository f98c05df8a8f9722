"""The service's REST calls that a client needs."""

import os
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from urllib.parse import urlsplit

import httpx
import numpy as np

from captra.geometry import Pose
from captra.recording import writer
from clients.credentials import Credentials
from clients.errors import RequestRefusedError, ServiceUnreachableError
from clients.regions import PACKED_BOX

DEFAULT_URL = "http://127.0.0.1:8080"
URL_VARIABLE = "CAPTRA_URL"
LOOK_AGAIN_S = 0.02
ANY_ADDRESS = ("0.0.0.0", "[::]")


@dataclass(frozen=True)
class OpenedSession:
    """What the service answers to `POST /v1/sessions`."""

    session_id: str
    """Names the session in REST paths and Zenoh keys."""
    category: str
    """What is tracked."""
    expires_after_s: float | None
    """Idle time after which the service closes the session by itself."""
    cloud_key: str
    """Zenoh key to put clouds to."""
    pose_key: str
    """Zenoh key that results come on."""
    event_key: str
    """Zenoh key that events come on."""
    token_key: str
    """Liveliness key of the client: when its token goes, so does the session."""
    endpoints: tuple[str, ...]
    """Where the service's Zenoh router listens."""
    secret: bytes = b""
    """Ends the attachment of every cloud; empty where the service asks for none."""


class Answer(dict[str, Any]):
    """The body of an answer; raises ServiceUnreachableError for a member that it lacks: a stranger gave it."""

    def __init__(self, url: str, members: Mapping[str, Any]) -> None:
        """`url` is who gave it."""
        super().__init__(members)
        self._url = url

    def __missing__(self, name: str) -> Any:
        raise stranger(self._url, f"without {name!r}")


class RestApi:
    """One HTTP connection to one service."""

    def __init__(self, url: str | None = None, timeout_s: float = 10.0) -> None:
        """Without `url`: what `CAPTRA_URL` says, else the address where a service listens by default.

        Raises:
            ServiceUnreachableError: this is no address.
            CredentialsError: what the environment names cannot be used.
        """
        self.url = url or os.environ.get(URL_VARIABLE) or DEFAULT_URL
        if not self.url.startswith(("http://", "https://")):
            raise no_address(self.url)
        self.timeout_s = timeout_s
        credentials = Credentials.from_environment()
        try:
            self._http = httpx.Client(
                base_url=self.url, timeout=timeout_s, headers=credentials.headers, verify=credentials.trust
            )
        except httpx.InvalidURL as error:
            raise no_address(self.url) from error

    def open(self, category: str, pose: Pose, options: Mapping[str, Any]) -> OpenedSession:
        """POST a session; options that are None are left to the service."""
        answer = self.post_session(session_body(category, pose, options))
        zenoh = answer["zenoh"]
        stem = zenoh["cloud"].removesuffix("/cloud")
        return OpenedSession(
            session_id=answer["session_id"],
            category=answer["category"],
            expires_after_s=answer.get("expires_after_s"),
            cloud_key=zenoh["cloud"],
            pose_key=zenoh["pose"],
            event_key=zenoh["event"],
            token_key=zenoh.get("liveliness", {}).get("client", f"{stem}/client"),
            endpoints=tuple(reachable(endpoint, self.url) for endpoint in zenoh["endpoints"]),
            secret=bytes.fromhex(zenoh.get("secret") or ""),
        )

    def post_session(self, body: Mapping[str, Any]) -> Mapping[str, Any]:
        """POST a session as it is described."""
        return self._call("POST", "/v1/sessions", json=body)

    def session(self, session_id: str) -> Mapping[str, Any]:
        """GET state, last result and counters."""
        return self._call("GET", f"/v1/sessions/{session_id}")

    def sessions(self) -> Sequence[Mapping[str, Any]]:
        """GET every session, oldest first."""
        return self._call("GET", "/v1/sessions")["sessions"]  # type: ignore[no-any-return]

    def network(self) -> Mapping[str, Any]:
        """GET where the deployment is reached by Zenoh."""
        answer = self._call("GET", "/v1/zenoh")
        return {**answer, "endpoints": tuple(reachable(endpoint, self.url) for endpoint in answer["endpoints"])}

    def wait_for_client(self, session_id: str) -> None:
        """Wait until the service knows the client of a session, and so what it listens to.

        Raises:
            ServiceUnreachableError: it does not learn of it within `timeout_s`.
        """
        deadline_s = time.monotonic() + self.timeout_s
        while not self.session(session_id)["client"]:
            if time.monotonic() > deadline_s:
                raise ServiceUnreachableError(
                    f"the service does not hear that this client is there for session {session_id}: a Zenoh router "
                    "between them lets clouds through and liveliness tokens not"
                )
            time.sleep(LOOK_AGAIN_S)

    def models(self) -> Sequence[Mapping[str, Any]]:
        """GET what can be tracked, and with what."""
        return self._call("GET", "/v1/models")["models"]  # type: ignore[no-any-return]

    def reset(self, session_id: str, pose: Pose) -> None:
        """PUT a new pose."""
        self.put_pose(session_id, {"parts": parts_of(pose)})

    def put_pose(self, session_id: str, body: Mapping[str, Any]) -> None:
        """PUT a new pose as it is described."""
        self._call("PUT", f"/v1/sessions/{session_id}/pose", json=body)

    def post_frame(
        self,
        session_id: str,
        payload: bytes,
        media_type: str,
        *,
        seq: int,
        stamp_ns: int,
        region: bytes = b"",
        looks: int | None = None,
    ) -> Mapping[str, Any]:
        """POST one frame with its mask or box, packed as in an attachment; the answer is its result."""
        path, params = f"/v1/sessions/{session_id}/frames", {"seq": str(seq), "stamp_ns": str(stamp_ns)}
        if looks is not None:
            params["looks"] = str(looks)
        if region and len(region) != PACKED_BOX.size:
            files = {"cloud": ("cloud", payload, media_type), "mask": ("mask.png", region, "image/png")}
            return self._call("POST", path, params=params, files=files)
        if region:
            params["box"] = ",".join(str(edge) for edge in PACKED_BOX.unpack(region))
        return self._call("POST", path, params=params, content=payload, headers={"Content-Type": media_type})

    def delete(self, session_id: str) -> None:
        """Close a session; one that is gone already is fine."""
        try:
            self._call("DELETE", f"/v1/sessions/{session_id}")
        except RequestRefusedError as error:
            if error.status != httpx.codes.NOT_FOUND:
                raise

    def check_ready(self) -> None:
        """Do nothing when the service is up, with networks loaded and kernels compiled.

        Raises:
            RequestRefusedError: it is not; `reason` is `hindered` where waiting does not help.
            ServiceUnreachableError: nothing answers yet.
        """
        self._call("GET", "/v1/health/ready")

    def close(self) -> None:
        """Close the connection."""
        self._http.close()

    def _call(self, method: str, path: str, **request: Any) -> Mapping[str, Any]:
        try:
            response = self._http.request(method, path, **request)
        except (httpx.RequestError, UnicodeError) as error:  # the latter of names that no network has
            raise ServiceUnreachableError(
                f"no captra service answers at {self.url} ({error}): start one with `captra serve`, "
                f"or say where it is with --url or {URL_VARIABLE}"
            ) from error
        if not response.is_success:
            raise refusal(response)
        if not response.content:
            return {}
        members = json_in(response)
        if not isinstance(members, dict):
            raise stranger(self.url, response.headers.get("Content-Type", "of no type"))
        return Answer(self.url, members)


def no_address(url: str) -> ServiceUnreachableError:
    """The exception for an address that is none."""
    return ServiceUnreachableError(f"{url} is no address of a service: write it like http://robot:8080")


def stranger(url: str, answer: str) -> ServiceUnreachableError:
    """The exception for an answer that no captra service gives."""
    return ServiceUnreachableError(
        f"what answers at {url} is no captra service (its answer is {answer}): say where one is with --url or "
        f"{URL_VARIABLE}"
    )


def json_in(response: httpx.Response) -> Any:
    """The content of an answer; none where it is no JSON."""
    try:
        return response.json()
    except ValueError:
        return None


def session_body(category: str, pose: Pose, options: Mapping[str, Any]) -> dict[str, Any]:
    """The body of a POST that opens a session; options that are None are left to the service."""
    chosen = {name: value for name, value in options.items() if value is not None}
    return {"category": category, "parts": parts_of(pose), **chosen}


def parts_of(pose: Pose) -> list[dict[str, Any]]:
    """A pose as the bodies of the REST API have it: one entry a part, rotation as a matrix, metres.

    Raises:
        ValueError: its arrays are not one entry a part, or hold NaN or infinity.
    """
    shapes = {name: np.shape(getattr(pose, name)) for name in ("rotation", "translation", "size")}
    parts = shapes["rotation"][:1]
    if not parts or list(shapes.values()) != [(*parts, 3, 3), (*parts, 3), (*parts, 3)]:
        told = ", ".join(f"{name} is {shape}" for name, shape in shapes.items())
        raise ValueError(
            f"a pose has one entry a part, rotation (P, 3, 3), translation (P, 3), size (P, 3), but {told}: "
            "for an object of one part write rotation[None], translation[None], size[None]"
        )
    if not all(np.isfinite(getattr(pose, name)).all() for name in shapes):
        raise ValueError("the pose holds NaN or infinity: was the object not seen? give numbers, metres")
    return writer.parts_of(pose)


def reachable(endpoint: str, url: str) -> str:
    """A Zenoh endpoint as a client reaches it: a service that listens on any address is where its REST API is."""
    for address in ANY_ADDRESS:
        endpoint = endpoint.replace(f"/{address}:", f"/{urlsplit(url).hostname}:")
    return endpoint


def refusal(response: httpx.Response) -> RequestRefusedError:
    """The exception for an answer that is no success, from its problem+json where it has one."""
    problem: Mapping[str, Any] = {}
    if "json" in response.headers.get("Content-Type", ""):
        body = json_in(response)
        problem = body if isinstance(body, dict) else {}
    detail = problem.get("detail") or problem.get("title") or response.reason_phrase
    return RequestRefusedError(response.status_code, problem.get("reason") or "unknown", str(detail))
