"""The secret of a session: whoever opened it may put clouds, and nobody else."""

import hashlib
import hmac
import secrets
from typing import Protocol

from service.rejections import WrongSecretError

SECRET_BYTES = 16


class Admission(Protocol):
    """Looks at the attachment of a cloud before anything else does."""

    def admit(self, attachment: bytes | None) -> bytes | None:
        """The attachment without the secret; raises WrongSecretError."""


class Anyone:
    """Clouds need no secret."""

    def admit(self, attachment: bytes | None) -> bytes | None:
        """The attachment as it is."""
        return attachment


class SecretHolders:
    """The last sixteen bytes of the attachment are the secret, of which only the digest is known here."""

    def __init__(self, sha256: str) -> None:
        self._sha256 = sha256

    def admit(self, attachment: bytes | None) -> bytes | None:
        """What comes before the secret; none when that is nothing.

        Raises:
            WrongSecretError: it is missing or another.
        """
        attachment = attachment or b""
        secret = attachment[-SECRET_BYTES:]
        if not hmac.compare_digest(hashlib.sha256(secret).hexdigest(), self._sha256):
            raise WrongSecretError(
                "this session takes clouds from the client that opened it: "
                "end the attachment with the 16 bytes of zenoh.secret"
            )
        return attachment[:-SECRET_BYTES] or None


def new_secret() -> bytes:
    """Sixteen bytes that nobody can guess."""
    return secrets.token_bytes(SECRET_BYTES)


def admission_of(sha256: str | None) -> Admission:
    """Who may put clouds, given the digest of the secret."""
    return Anyone() if sha256 is None else SecretHolders(sha256)
