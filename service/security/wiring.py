"""From settings to whoever decides; and the refusal to be open to others unless told so."""

import ipaddress
from pathlib import Path
from typing import Any

from service.security.access import ApiKeys, Caller, Credentials, Gate, GuardedGate, OpenGate, Permission
from service.settings import Settings, ZenohAccess

READING = ["declare_subscriber", "query", "liveliness_query", "declare_liveliness_subscriber"]
ANSWERS = ["put", "reply", "liveliness_token", "declare_queryable", "declare_subscriber"]


class ExposedError(RuntimeError):
    """The service would be open to other machines without having been told so; says what to do."""


def is_guarded(settings: Settings) -> bool:
    """Whether callers of the REST API have to say who they are."""
    return bool(settings.api_keys) or settings.token_key_file is not None


def clouds_need_secrets(settings: Settings) -> bool:
    """Whether sessions are opened with a secret: as the settings say, otherwise where REST is guarded."""
    return is_guarded(settings) if settings.cloud_secrets is None else settings.cloud_secrets


def gate_of(settings: Settings) -> Gate:
    """Who decides on requests."""
    if not is_guarded(settings):
        return OpenGate()
    keys = {key.sha256: Caller(key.name, Permission[key.may.upper()]) for key in settings.api_keys}
    credentials: list[Credentials] = [ApiKeys(keys)]
    if settings.token_key_file is not None:
        from service.security.tokens import SignedTokens

        credentials.append(SignedTokens(settings.token_key_file, settings.token_algorithm, settings.token_audience))
    return GuardedGate(credentials)


def check_exposure(settings: Settings) -> None:
    """Refuse to start where others could reach a service that anybody may use.

    Raises:
        ExposedError: an interface is not loopback, nothing guards it, and `allow_open` is not set.
    """
    if settings.allow_open:
        return
    if not is_loopback(settings.http_host) and not is_guarded(settings):
        raise ExposedError(
            f"the REST API would be open to whoever reaches {settings.http_host}: set api_keys or token_key_file "
            "(captra certify writes a file of settings), or CAPTRA_ALLOW_OPEN=true if that is what you want"
        )
    mutual_tls = settings.zenoh_tls_ca is not None
    for endpoint in settings.zenoh_listen:
        protected = mutual_tls and endpoint.partition("/")[0] in {"tls", "quic"}
        if not (protected or is_loopback(host_of(endpoint)) or clouds_need_secrets(settings)):
            if settings.ros2:
                raise ExposedError(
                    f"anybody who reaches {endpoint} could put clouds, and publishers on topics know neither secrets "
                    "nor certificates: keep the port within the robot's own network and set CAPTRA_ALLOW_OPEN=true, or "
                    "listen on loopback"
                )
            raise ExposedError(
                f"anybody who reaches {endpoint} could put clouds: set cloud_secrets, api_keys, or zenoh_tls_* with a "
                "tls/ endpoint (captra certify writes all that), or CAPTRA_ALLOW_OPEN=true if that is what you want"
            )


def zenoh_entries(settings: Settings) -> dict[str, Any]:
    """Entries of Zenoh's configuration: certificates of both sides, and what each client may do."""
    entries: dict[str, Any] = {}
    tls = "transport/link/tls"
    if settings.zenoh_tls_cert is not None:
        entries[f"{tls}/listen_certificate"] = str(settings.zenoh_tls_cert)
        entries[f"{tls}/listen_private_key"] = str(settings.zenoh_tls_key)
    if settings.zenoh_tls_ca is not None:
        entries[f"{tls}/root_ca_certificate"] = str(settings.zenoh_tls_ca)
        entries[f"{tls}/enable_mtls"] = True
    if settings.zenoh_access:
        entries["access_control"] = access_control(settings.service, settings.zenoh_access)
    return entries


def access_control(service: str, granted: tuple[ZenohAccess, ...]) -> dict[str, Any]:
    """Rules by the common names of clients' certificates; what no rule allows is denied."""
    everything, session = f"captra/{service}/**", f"captra/{service}/sessions/*"
    kept = f"{session}/pose/@adv/**"  # the last result, for late subscribers; ** alone matches no chunk with an @
    rules = [
        rule("listen", "ingress", READING, everything, kept),
        rule("hear", "egress", ANSWERS, everything, kept),
        rule("feed", "ingress", ["put"], f"{session}/cloud"),
        rule("preview", "ingress", ["put"], f"captra/{service}/previews/*"),
        rule("live", "ingress", ["liveliness_token"], f"{session}/client"),
    ]
    allowed = {"watch": ["listen", "hear"], "stream": ["listen", "hear", "feed", "preview", "live"]}
    subjects = [{"id": each.common_name, "cert_common_names": [each.common_name]} for each in granted]
    policies = [{"rules": allowed[each.may], "subjects": [each.common_name]} for each in granted]
    return {
        "enabled": True,
        "default_permission": "deny",
        "rules": rules,
        "subjects": subjects,
        "policies": policies,
    }


def rule(name: str, flow: str, messages: list[str], *key_expressions: str) -> dict[str, Any]:
    """Something that is allowed."""
    return {"id": name, "permission": "allow", "flows": [flow], "messages": messages, "key_exprs": key_expressions}


def is_loopback(host: str) -> bool:
    """Whether only this machine reaches a host."""
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return host == "localhost"


def host_of(endpoint: str) -> str:
    """The host of a Zenoh endpoint, e.g. of `tls/[::1]:7447#so_sndbuf=65535`; loopback for a socket in a file."""
    protocol, _, address = endpoint.partition("/")
    if protocol.startswith("unix"):
        return "localhost"
    return address.partition("#")[0].partition("?")[0].rpartition(":")[0]


def check_files(settings: Settings) -> None:
    """Refuse settings that name files which are not there.

    Raises:
        FileNotFoundError: one is missing.
    """
    names = ("token_key_file", "http_tls_cert", "http_tls_key", "zenoh_tls_cert", "zenoh_tls_key", "zenoh_tls_ca")
    for name in names:
        path: Path | None = getattr(settings, name)
        if path is not None and not path.is_file():
            raise FileNotFoundError(f"setting {name}: there is no file {path}")
