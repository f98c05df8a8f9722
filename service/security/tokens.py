"""Signed bearer tokens (JWT, RFC 7519): whoever holds the signing key lets callers in, without the service's help."""

from pathlib import Path

import jwt

from service.security.access import Caller, Permission

SCOPES = {"captra:read": Permission.READ, "captra:write": Permission.WRITE}


class SignedTokens:
    """Tokens that name a subject, an audience, an end, and in `scope` what the subject may do."""

    def __init__(self, key_file: Path, algorithm: str, audience: str) -> None:
        """`key_file` holds the public key (PEM), or for HS256 the shared secret.

        Raises:
            OSError: it cannot be read.
        """
        self._key = key_file.read_bytes().strip()
        self._algorithm = algorithm
        self._audience = audience

    def identify(self, bearer: str) -> Caller | None:
        """The subject of a token that is valid now."""
        try:
            claims = jwt.decode(
                bearer,
                self._key,
                algorithms=[self._algorithm],
                audience=self._audience,
                options={"require": ["exp", "sub", "aud"]},
            )
        except jwt.InvalidTokenError:
            return None
        scopes = str(claims.get("scope", "")).split()
        may = max((SCOPES.get(scope, Permission.NOTHING) for scope in scopes), default=Permission.NOTHING)
        return Caller(str(claims["sub"]), may)
