"""Who calls, and whether that is allowed."""

import hashlib
import hmac
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Protocol

from service.rejections import ForbiddenError, UnauthorizedError


class Permission(IntEnum):
    """What a caller may do; each includes those before it."""

    NOTHING = 0
    READ = 1
    WRITE = 2


@dataclass(frozen=True)
class Caller:
    """Whoever sent a request."""

    name: str
    """For logs: the name of the key, or the subject of the token."""
    may: Permission
    """What is allowed."""


ANYBODY = Caller("anybody", Permission.WRITE)


class Credentials(Protocol):
    """One way to prove who one is."""

    def identify(self, bearer: str) -> Caller | None:
        """The caller that this is the bearer token of; none when this way does not know it."""


class ApiKeys:
    """Keys of which only the digests are known here."""

    def __init__(self, callers_by_sha256: dict[str, Caller]) -> None:
        self._callers = callers_by_sha256

    def identify(self, bearer: str) -> Caller | None:
        """The caller with this key."""
        digest = sha256_of(bearer)
        matches = [caller for known, caller in self._callers.items() if hmac.compare_digest(known, digest)]
        return matches[0] if matches else None


class Gate(Protocol):
    """Decides on requests."""

    def admit(self, bearer: str | None, needed: Permission) -> Caller:
        """The caller, when it is allowed.

        Raises:
            UnauthorizedError: nobody knows who this is.
            ForbiddenError: it is known, and not allowed.
        """


class OpenGate:
    """Anybody may do anything: on loopback, or where an operator said so."""

    def admit(self, bearer: str | None, needed: Permission) -> Caller:  # noqa: ARG002 - the protocol names them
        """Anybody."""
        return ANYBODY


class GuardedGate:
    """Only those with credentials come in."""

    def __init__(self, credentials: Sequence[Credentials]) -> None:
        self._credentials = credentials

    def admit(self, bearer: str | None, needed: Permission) -> Caller:
        """The caller, when its credentials are known and suffice."""
        if needed is Permission.NOTHING:
            return ANYBODY
        if bearer is None:
            raise UnauthorizedError("this service asks who you are: send Authorization: Bearer with a key or token")
        for way in self._credentials:
            caller = way.identify(bearer)
            if caller is not None:
                if caller.may < needed:
                    raise ForbiddenError(f"{caller.name} may read only: use a key or token that may write")
                return caller
        raise UnauthorizedError("the key or token is unknown, expired or not for this service: get a new one")


def sha256_of(secret: str) -> str:
    """Digest of a key, hexadecimal, as the settings have it."""
    return hashlib.sha256(secret.encode()).hexdigest()
