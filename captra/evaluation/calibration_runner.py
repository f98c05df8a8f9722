"""Collects what a confidence is fitted to: first tracks as they come, then searches that a first fit steers."""

from collections.abc import Sequence

import numpy as np

from captra.belief import Persistence
from captra.evaluation.calibration import Observations, fit_confidence, observations
from captra.evaluation.incident_runner import Rehearsal, watch_all
from captra.evaluation.incidents import BRIEF, INCIDENTS
from captra.evaluation.runner import NetworksSource
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.thresholds import choose_thresholds
from captra.evaluation.watching import Watched
from captra.evaluation.workers import Workers
from captra.health import HealthMonitor

FAULTS = tuple(kind for kind in INCIDENTS if kind != "nothing")
LEAST_USUAL = 0.05
"""Share of right frames, and of wrong ones, that a track may expect though a few sequences showed none."""

SHARES_OF_NEWS = (1.0, 0.7, 0.5, 0.35, 0.25)
"""How much each frame may tell that those before it did not, the usual share first."""

FAULTS_SEARCHED = 3
"""Incidents of each sequence that are watched with a search: four sequences see every kind at least once."""


def calibrated(
    networks: NetworksSource, sources: Sequence[SequenceSource], workers: Workers, looks: int
) -> tuple[HealthMonitor, Observations]:
    """A monitor for these networks, and what it was fitted to.

    A search shows the confidence what looks best among many wrong places, which tracks without one never do; so the
    second round watches searches, steered by the fit to the first.
    """
    calm = [Rehearsal(source, ("nothing", FAULTS[i % len(FAULTS)]), i, BRIEF) for i, source in enumerate(sources)]
    first = [one for some in watch_all(networks, calm, workers, {}, 1) for one in some]
    searching = [Rehearsal(source, faults(i), i, BRIEF) for i, source in enumerate(sources)]
    steering = monitor_of(first).calibration
    second = [one for some in watch_all(networks, searching, workers, steering, looks) for one in some]
    return monitor_of([*first, *second]), observations([*first, *second])


def monitor_of(watched: Sequence[Watched]) -> HealthMonitor:
    """The monitor that fits these tracks: what single frames tell, then thresholds on what is believed of them."""
    found = observations(watched)
    usual = float(np.clip(found.correct.all(axis=1).mean(), LEAST_USUAL, 1 - LEAST_USUAL))
    beliefs = [Persistence(usual, news=news) for news in SHARES_OF_NEWS]
    return choose_thresholds(fit_confidence(found), watched, beliefs)


def faults(index: int) -> tuple[str, ...]:
    """Kinds of incidents for one of many sequences: those after the ones of the sequence before."""
    first = index * FAULTS_SEARCHED
    return tuple(FAULTS[i % len(FAULTS)] for i in range(first, first + FAULTS_SEARCHED))
