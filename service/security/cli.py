"""`captra certify`: everything that a guarded service and its clients need, in one folder."""

import secrets
from pathlib import Path
from typing import Annotated

import typer

from captra.errors import UserError

TEMPLATE = """\
# Settings of a guarded service: captra serve --config {folder}/captra.toml
http_host = "0.0.0.0"
http_tls_cert = "{folder}/service.pem"
http_tls_key = "{folder}/service.key"
zenoh_listen = ["tls/0.0.0.0:7447"]
zenoh_tls_cert = "{folder}/service.pem"
zenoh_tls_key = "{folder}/service.key"
zenoh_tls_ca = "{folder}/ca.pem"
"""
CLIENT = """
[[api_keys]]
name = "{name}"
sha256 = "{sha256}"
may = "write"

[[zenoh_access]]
common_name = "{name}"
may = "stream"
"""


def certify(
    folder: Annotated[Path, typer.Argument(help="Where to write; an authority that is there is used again.")],
    host: Annotated[
        list[str], typer.Option(help="Name or address by which clients reach the service, may be repeated.")
    ],
    client: Annotated[list[str], typer.Option(help="Name of a client, may be repeated.")],
) -> None:
    """Make a local certificate authority, certificates and API keys, and the settings of a service that asks for them.

    Copy ca.pem and what is in clients/NAME to each client, and keep ca.key to yourself.

    Example: `captra certify deployment/keys --host robot-cell.local --host 10.0.0.5 --client arm-1`
    """
    folder = folder.resolve()
    try:
        write_all(folder, host, client)
    except OSError as error:
        raise UserError(f"cannot write to {folder} ({error.strerror}): name a folder that can be written") from error
    typer.echo(f"Start the service with: captra serve --config {folder}/captra.toml")
    typer.echo(f"On a client, set CAPTRA_CA_FILE={folder}/ca.pem and, from {folder}/clients/NAME/:")
    typer.echo("  CAPTRA_API_KEY=$(cat api-key) CAPTRA_CLIENT_CERT=client.pem CAPTRA_CLIENT_KEY=client.key")


def write_all(folder: Path, hosts: list[str], clients: list[str]) -> None:
    """The authority, everybody's certificates and keys, and the settings."""
    from service.security.access import sha256_of
    from service.security.authority import Identity, issue, new_authority, write_private

    if (folder / "ca.key").exists():
        authority = Identity.read(folder, "ca")
    else:
        authority = new_authority()
        authority.write(folder, "ca")
    issue(authority, "captra service", hosts).write(folder, "service")
    settings = TEMPLATE.format(folder=folder)
    for name in clients:
        place, key_file = folder / "clients" / name, folder / "clients" / name / "api-key"
        if not key_file.exists():
            issue(authority, name).write(place, "client")
            write_private(key_file, secrets.token_urlsafe(32).encode())
        settings += CLIENT.format(name=name, sha256=sha256_of(key_file.read_text()))
    (folder / "captra.toml").write_text(settings)
