"""Collects what a confidence is fitted to: first tracks as they come, then searches that a first fit steers."""

from collections.abc import Sequence

from captra.evaluation.calibration import Observations, fit_confidence, observations
from captra.evaluation.incident_runner import Rehearsal, watch_all
from captra.evaluation.incidents import BRIEF, INCIDENTS
from captra.evaluation.runner import NetworksSource
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.thresholds import choose_thresholds
from captra.evaluation.workers import Workers
from captra.health import HealthMonitor

FAULTS = tuple(kind for kind in INCIDENTS if kind != "nothing")


def calibrated(
    networks: NetworksSource, sources: Sequence[SequenceSource], workers: Workers, looks: int
) -> tuple[HealthMonitor, Observations]:
    """A monitor for these networks, and what it was fitted to.

    A search shows the confidence what looks best among many wrong places, which tracks without one never do; so the
    second round watches searches, steered by the fit to the first.
    """
    calm = [Rehearsal(source, ("nothing", fault(i)), i, BRIEF) for i, source in enumerate(sources)]
    first = [one for some in watch_all(networks, calm, workers, {}, 1) for one in some]
    steering = choose_thresholds(fit_confidence(observations(first)), first).calibration
    searching = [Rehearsal(source, (fault(i + 3),), i, BRIEF) for i, source in enumerate(sources)]
    second = [one for some in watch_all(networks, searching, workers, steering, looks) for one in some]
    found = observations([*first, *second])
    return choose_thresholds(fit_confidence(found), [*first, *second]), found


def fault(index: int) -> str:
    """One kind of incident after the other."""
    return FAULTS[index % len(FAULTS)]
