"""What a client shows to a guarded service, and whom it believes."""

import os
import ssl
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from clients.errors import CredentialsError


@dataclass(frozen=True)
class Credentials:
    """All of it optional: a service on loopback asks for nothing."""

    api_key: str | None = None
    """API key or signed token for the REST API."""
    ca_file: Path | None = None
    """Authority (PEM) that the service's certificates have to come from, by HTTPS and Zenoh."""
    certificate: Path | None = None
    """The client's own certificate (PEM), for Zenoh with mutual TLS."""
    key: Path | None = None
    """Its private key."""

    @classmethod
    def from_environment(cls) -> Self:
        """What CAPTRA_API_KEY, CAPTRA_CA_FILE, CAPTRA_CLIENT_CERT and CAPTRA_CLIENT_KEY say."""
        ca_file, certificate, key = (
            Path(value) if (value := os.environ.get(f"CAPTRA_{name}")) else None
            for name in ("CA_FILE", "CLIENT_CERT", "CLIENT_KEY")
        )
        return cls(os.environ.get("CAPTRA_API_KEY") or None, ca_file, certificate, key)

    @property
    def headers(self) -> dict[str, str]:
        """Of every request.

        Raises:
            CredentialsError: no header can hold the key.
        """
        if self.api_key is not None and not (self.api_key.isascii() and self.api_key.isprintable()):
            raise CredentialsError("CAPTRA_API_KEY holds characters that no key has: copy the key again")
        return {} if self.api_key is None else {"Authorization": f"Bearer {self.api_key}"}

    @property
    def trust(self) -> ssl.SSLContext | bool:
        """Whom HTTPS believes.

        Raises:
            CredentialsError: the authority's certificate cannot be read.
        """
        if self.ca_file is None:
            return True
        try:
            return ssl.create_default_context(cafile=self.ca_file)
        except OSError as error:  # also where it is no PEM
            raise CredentialsError(
                f"CAPTRA_CA_FILE names {self.ca_file}, which cannot be read as a certificate ({error.strerror}): name "
                "the authority's PEM file, such as the ca.pem of captra certify, or unset it"
            ) from error

    @property
    def zenoh_entries(self) -> dict[str, str | bool]:
        """Entries of a Zenoh configuration."""
        entries: dict[str, str | bool] = {}
        if self.ca_file is not None:
            entries["transport/link/tls/root_ca_certificate"] = str(self.ca_file)
        if self.certificate is not None:
            entries["transport/link/tls/connect_certificate"] = str(self.certificate)
            entries["transport/link/tls/connect_private_key"] = str(self.key)
            entries["transport/link/tls/enable_mtls"] = True
        return entries
