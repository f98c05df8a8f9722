"""What can go wrong between a client and the service."""

from captra.errors import UserError


class ClientError(UserError):
    """Anything that this client raises about the service."""


class ServiceUnreachableError(ClientError):
    """Nothing answers at the address."""


class CredentialsError(ClientError):
    """What the environment says to show to a guarded service, or whom to believe, cannot be used."""


class RequestRefusedError(ClientError):
    """The service answered a request with problem+json (RFC 9457)."""

    def __init__(self, status: int, reason: str, detail: str) -> None:
        super().__init__(f"{detail} (HTTP {status}, {reason})")
        self.status = status
        """HTTP status code."""
        self.reason = reason
        """Short machine-readable reason, the same word as in the service's metrics."""
        self.detail = detail
        """What is wrong and what to do about it."""


class FrameRejectedError(ClientError):
    """The service could not use a cloud; the session is as it was before."""

    def __init__(self, seq: int | None, reason: str, detail: str) -> None:
        super().__init__(f"frame {seq} was rejected: {detail} ({reason})")
        self.seq = seq
        """Number of the frame, as `Session.put` returned it."""
        self.reason = reason
        """Short machine-readable reason, the same word as in the service's metrics."""


class SessionClosedError(ClientError):
    """The session is closed: by the service, after a time-out or on request, or by this client."""


class NoResultError(ClientError):
    """No result came within the time given."""
