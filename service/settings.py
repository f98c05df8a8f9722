"""Settings of the service: `CAPTRA_*` variables over a TOML file over defaults that work."""

import os
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StringConstraints, model_validator
from pydantic_settings import BaseSettings, PydanticBaseSettingsSource, SettingsConfigDict, TomlConfigSettingsSource

from captra import shipped
from service.ros2.names import check_topic
from service.track_options import Prediction

CONFIG_VARIABLE = "CAPTRA_CONFIG"
"""Names the TOML file whose keys are the field names below."""

ProfileName = Literal["realtime", "paper"]
KeyChunk = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_]+(-[A-Za-z0-9_]+)*$", max_length=64)]


class ApiKey(BaseModel):
    """A key by which a caller of the REST API is known."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    name: str = Field(min_length=1, max_length=100)
    sha256: str = Field(pattern="^[0-9a-f]{64}$")
    may: Literal["read", "write"] = "write"


class ZenohAccess(BaseModel):
    """What the holder of a client certificate may do by Zenoh: watch all sessions, or put clouds as well."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    common_name: str = Field(min_length=1, max_length=64)
    may: Literal["watch", "stream"] = "stream"


def ros_domain() -> Any:
    """What the variables of ROS say, unchecked."""
    return os.environ.get("ROS_DOMAIN_ID") or "0"


class MissingConfigError(FileNotFoundError):
    """The file of settings does not exist."""


class MalformedConfigError(ValueError):
    """The file of settings cannot be read."""


class Settings(BaseSettings):
    """Everything an operator can choose."""

    model_config = SettingsConfigDict(env_prefix="CAPTRA_", extra="forbid", frozen=True, validate_default=True)

    http_host: str = "127.0.0.1"
    """Interface of the REST server."""
    http_port: int = Field(default=8080, ge=0, le=65535)
    """Port of the REST server; 0 takes a free one."""
    zenoh_listen: tuple[str, ...] = Field(default=("tcp/127.0.0.1:7447",), min_length=1)
    """Endpoints of the embedded Zenoh router."""
    zenoh_advertise: tuple[str, ...] = ()
    """Endpoints told to clients, where they differ from those listened on (behind NAT or a port mapping)."""
    zenoh_connect: tuple[str, ...] = ()
    """Endpoints of other routers that the embedded one connects to, and goes on trying to."""
    ros2: bool = False
    """Whether the service is a node of ROS 2: takes topics of clouds, publishes boxes, transforms and joint states."""
    ros2_domain: int = Field(default_factory=ros_domain, ge=0, le=232)
    """Domain of that node; by default what ROS_DOMAIN_ID says, else 0."""
    ros2_distribution: Literal["humble", "jazzy", "kilted", "lyrical"] = "jazzy"
    """Of the nodes on rmw_zenoh: those of Humble know no type hashes."""
    ros2_points_topic: Annotated[str, AfterValidator(check_topic)] | None = None
    """Topic that feeds sessions which name none."""
    service: KeyChunk = "default"
    """Name of this deployment in every Zenoh key; another process that takes the deployment over keeps it."""
    models_dir: Path = shipped.MODELS
    """Folder of model bundles, one a category."""
    preload: tuple[str, ...] = ()
    """Categories whose networks are in memory before the service is ready. Others follow when a session of theirs is
    opened, which holds up the frames of all for a moment; without any, the first one that can be loaded is."""
    recordings_dir: Path = shipped.RECORDINGS
    """Folder of recordings that the live page offers to play."""
    state_dir: Path = Field(default_factory=lambda: Path.home() / ".local" / "state" / "captra")
    """Folder for state that outlives the process: one SQLite file of sessions for each deployment."""
    record_dir: Path | None = None
    """Folder of sessions that the service records; by default `recordings` in the state folder."""
    record_max_bytes: int = Field(default=2**30, ge=2**20)
    """Size of the recording of one session, which ends there."""
    record_max_total_bytes: int = Field(default=10 * 2**30, ge=2**20)
    """Size of all recordings; when they have it, no other is begun."""
    profile: ProfileName = "realtime"
    """Sampling budget of sessions that name none."""
    provider: str = "auto"
    """Execution provider of ONNX Runtime: `cpu`, `openvino` or `cuda`. `auto` is OpenVINO where it is installed and the
    CPU multiplies in bfloat16, else the plain CPU: a GPU has to be named."""
    threads: int | None = Field(default=None, ge=1)
    """Threads of one network run; by default what the container's quota allows."""
    search_budget_ms: float = Field(default=100.0, ge=0, le=10_000, allow_inf_nan=False)
    """How long a frame may look for an object that is doubted or lost, two looks at the least; 0 never searches."""
    prediction: Prediction = "constant-velocity"
    """How sessions that do not say expect the next pose; `captra health` measures what it helps."""
    max_sessions: int = Field(default=64, ge=1)
    """Sessions open at the same time."""
    frames_at_once: int = Field(default=4, ge=1)
    """Frames in hand at the same time, of all sessions together; the others wait, the newest of each session."""
    max_points: int = Field(default=1_000_000, ge=1)
    """Points of one cloud."""
    max_payload_bytes: int = Field(default=16 * 2**20, ge=1)
    """Size of one cloud, by Zenoh or as the body of a frame by HTTP."""
    max_body_bytes: int = Field(default=2**20, ge=1)
    """Size of any other HTTP body."""
    idle_timeout_s: float = Field(default=300.0, gt=0, allow_inf_nan=False)
    """A session that gets no frame for so long is closed; sessions may ask for another value."""
    max_idle_timeout_s: float = Field(default=86_400.0, gt=0, allow_inf_nan=False)
    """The longest idle time a session may ask for."""
    client_grace_s: float = Field(default=10.0, ge=0, allow_inf_nan=False)
    """How long a session outlives the liveliness token of its client."""
    shutdown_timeout_s: float = Field(default=3.0, gt=0, allow_inf_nan=False)
    """How long requests and frames in hand may take to finish when the service stops."""
    api_keys: tuple[ApiKey, ...] = ()
    """Who may call the REST API; of each key only the SHA-256 digest is written down."""
    token_key_file: Path | None = None
    """Key that signed bearer tokens (JWT) are checked with: a public key (PEM), or for HS256 the shared secret."""
    token_algorithm: Literal["EdDSA", "ES256", "RS256", "HS256"] = "EdDSA"
    """How tokens are signed."""
    token_audience: str = "captra"
    """Whom tokens have to be for (`aud`)."""
    cloud_secrets: bool | None = None
    """Whether clouds by Zenoh need the secret of their session; by default where the REST API asks who calls."""
    allow_open: bool = False
    """Start although other machines reach the service and nothing guards it."""
    http_tls_cert: Path | None = None
    """Certificate (PEM) of the REST API, which then speaks HTTPS alone."""
    http_tls_key: Path | None = None
    """Its private key."""
    zenoh_tls_cert: Path | None = None
    """Certificate (PEM) of the router's `tls/` endpoints."""
    zenoh_tls_key: Path | None = None
    """Its private key."""
    zenoh_tls_ca: Path | None = None
    """Authority that Zenoh clients' certificates have to come from: mutual TLS."""
    zenoh_access: tuple[ZenohAccess, ...] = ()
    """What each client may do by Zenoh, by the common name of its certificate; nobody else may do anything."""
    log_level: Literal["debug", "info", "warning", "error"] = "info"
    """Least severe log entries that are written."""

    @model_validator(mode="after")
    def certificates_have_keys(self) -> Self:
        """A certificate is of no use without its key, nor rules without certificates."""
        for face in ("http", "zenoh"):
            if (getattr(self, f"{face}_tls_cert") is None) != (getattr(self, f"{face}_tls_key") is None):
                raise ValueError(f"give both {face}_tls_cert and {face}_tls_key, or neither")
        if self.zenoh_tls_ca is not None and self.zenoh_tls_cert is None:
            raise ValueError("zenoh_tls_ca needs zenoh_tls_cert and zenoh_tls_key")
        if self.zenoh_access and self.zenoh_tls_ca is None:
            raise ValueError("zenoh_access needs zenoh_tls_ca: clients are known by their certificates")
        return self

    @model_validator(mode="after")
    def ros2_fits_the_rest(self) -> Self:
        """Nodes of ROS 2 have no certificates that access rules could know them by."""
        if self.ros2 and self.zenoh_access:
            raise ValueError("zenoh_access keeps out nodes of ROS 2, which show no certificates: leave one of them out")
        if self.ros2_points_topic is not None and not self.ros2:
            raise ValueError("ros2_points_topic needs ros2: start with --ros2 or CAPTRA_ROS2=true")
        return self

    @classmethod
    def settings_customise_sources(
        cls,
        settings_cls: type[BaseSettings],
        init_settings: PydanticBaseSettingsSource,
        env_settings: PydanticBaseSettingsSource,
        dotenv_settings: PydanticBaseSettingsSource,  # noqa: ARG003 - pydantic names it
        file_secret_settings: PydanticBaseSettingsSource,  # noqa: ARG003 - pydantic names it
    ) -> tuple[PydanticBaseSettingsSource, ...]:
        """Arguments win over the environment, which wins over the file.

        Raises:
            MissingConfigError: when the file does not exist.
            MalformedConfigError: when it is no TOML.
        """
        sources: tuple[PydanticBaseSettingsSource, ...] = (init_settings, env_settings)
        config = settings_cls.model_config.get("toml_file") or os.environ.get(CONFIG_VARIABLE)
        if not config:
            return sources
        if not Path(str(config)).is_file():
            raise MissingConfigError(f"there is no settings file {config}: correct --config or {CONFIG_VARIABLE}")
        try:
            return (*sources, TomlConfigSettingsSource(settings_cls, Path(str(config))))
        except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
            raise MalformedConfigError(f"{config} is no TOML ({error}): write lines like http_port = 8080") from error


def load_settings(config: Path | None, chosen: Mapping[str, Any]) -> Settings:
    """The settings of a process: what was chosen on its command line, then variables, then the file.

    Raises:
        MissingConfigError: the file does not exist.
        MalformedConfigError: it is no TOML.
        pydantic.ValidationError: a value is not valid.
        pydantic_settings.SettingsError: a value is no JSON where JSON is needed.
    """

    class Configured(Settings):
        model_config = SettingsConfigDict(toml_file=config)

    return Configured(**chosen)
