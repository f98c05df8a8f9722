"""The networks that sessions track with: loaded once for each category and profile, shared by all sessions."""

import logging
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from typing import Any, Generic, Protocol, TypeVar

from captra.geometry import Pose
from captra.health import HealthMonitor
from captra.looking import Networks
from captra.tracker import Tracker, TrackerOptions

Loaded = TypeVar("Loaded")


@dataclass(frozen=True)
class Engine:
    """What the trackers of one category and profile share."""

    networks: Networks
    """Both networks; they keep nothing between two runs."""
    health: HealthMonitor = field(default_factory=HealthMonitor)
    """Calibrated on these networks."""

    def start(self, pose: Pose, options: TrackerOptions | None = None) -> Tracker:
        """A tracker of one object; without options it does what the paper says."""
        return Tracker(self.networks, pose, self.health, options)


logger = logging.getLogger(__name__)


@dataclass(frozen=True)
class Model:
    """What can be tracked, and with what."""

    category: str
    """What the networks were trained on."""
    precision: str
    """Of the weights as stored."""
    provider: str
    """What runs them; `auto` until the first profile is loaded and has chosen."""
    profiles: tuple[str, ...]
    """Sampling budgets that sessions may ask for."""
    loaded: tuple[str, ...]
    """Profiles whose networks are in memory."""
    error: str | None
    """Why the bundle cannot be used, if so."""
    manifest: Mapping[str, Any]
    """The bundle's manifest: parts, shapes, hashes, training, scores."""


class NetworksProvider(Protocol):
    """Where networks come from; its methods may be called from any thread."""

    def prepare(self) -> None:
        """Load and warm what sessions will need first, so that no frame has to wait.

        Raises:
            NoModelError: when nothing can be tracked.
        """

    def get(self, category: str, profile: str) -> Engine:
        """Networks of a category, loaded now unless they are already.

        Raises:
            CategoryWithoutModelError: there are none.
            ModelNotLoadableError: there are, but they cannot be loaded.
        """

    def models(self) -> Sequence[Model]:
        """Everything there is."""


class NoModelError(RuntimeError):
    """Nothing can be tracked; says where models are looked for."""


class LoadedOnce(Generic[Loaded]):
    """Loads networks at most once for each category and profile, also when many ask at the same time."""

    def __init__(self, load: Callable[[str, str], Loaded]) -> None:
        self._load = load
        self._lock = threading.Lock()
        self._futures: dict[tuple[str, str], Future[Loaded]] = {}

    def get(self, category: str, profile: str) -> Loaded:
        """The networks; raises whatever loading them raises, and tries again the next time."""
        key = (category, profile)
        with self._lock:
            future = self._futures.get(key)
            if future is not None:
                mine = False
            else:
                mine, future = True, Future()
                self._futures[key] = future
        if mine:
            self._fill(key, future)
        return future.result()

    def loaded(self, category: str) -> dict[str, Loaded]:
        """Networks of a category that are in memory, by profile."""
        with self._lock:
            entries = [(*key, future) for key, future in self._futures.items()]
        return {
            profile: future.result()
            for name, profile, future in entries
            if name == category and future.done() and future.exception() is None
        }

    def _fill(self, key: tuple[str, str], future: Future[Loaded]) -> None:
        try:
            future.set_result(self._load(*key))
        except BaseException as error:  # noqa: BLE001 - whoever asked gets it from the future
            with self._lock:
                del self._futures[key]
            future.set_exception(error)
