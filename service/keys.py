"""The Zenoh keys of a deployment: they name the deployment and the session, never a process."""

from dataclasses import dataclass

CLOUD, POSE, EVENT, ALIVE, CLIENT = "cloud", "pose", "event", "alive", "client"


@dataclass(frozen=True)
class SessionKeys:
    """Keys of one session."""

    cloud: str
    """Clients put clouds here."""
    pose: str
    """The service puts results here."""
    event: str
    """The service puts events here."""
    alive: str
    """Liveliness token of the service for this session."""
    client: str
    """Liveliness token of the session's client: when it goes, the session follows after a grace time."""


@dataclass(frozen=True)
class ServiceKeys:
    """Keys of one deployment."""

    service: str
    """Name of the deployment."""

    @property
    def alive(self) -> str:
        """Liveliness token of the service."""
        return f"captra/{self.service}/{ALIVE}"

    @property
    def sessions(self) -> str:
        """Keys of a session are below this one and its id."""
        return f"captra/{self.service}/sessions"

    @property
    def clients(self) -> str:
        """Key expression of the tokens of all clients."""
        return f"{self.sessions}/*/{CLIENT}"

    @property
    def previews(self) -> str:
        """Clouds that no session tracks are put below this key; what follows is a name that the client chooses."""
        return f"captra/{self.service}/previews"

    def session(self, session_id: str) -> SessionKeys:
        """Keys of a session."""
        root = f"{self.sessions}/{session_id}"
        return SessionKeys(*(f"{root}/{leaf}" for leaf in (CLOUD, POSE, EVENT, ALIVE, CLIENT)))
