from captra.belief import Persistence
from captra.evaluation.calibration_runner import FAULTS, calibrated, faults
from captra.evaluation.incidents import INCIDENTS
from captra.evaluation.sequences import Sequence
from captra.evaluation.workers import Here
from captra.health import HealthMonitor
from tests.captra.evaluation.test_evaluation import Held, Ready, still_recording
from tests.oracle import OracleNetworks


def test_four_sequences_see_every_kind_of_incident_searched_for() -> None:
    seen = {kind for index in range(4) for kind in faults(index)}
    assert seen == set(FAULTS) == set(INCIDENTS) - {"nothing"}
    assert all(len(set(faults(index))) == len(faults(index)) for index in range(20))


def test_a_calibrated_monitor_tells_right_from_wrong_and_fits_into_a_manifest() -> None:
    recording = still_recording("camera", 24)
    truth = recording.truth(0)
    networks = Ready(OracleNetworks(recording.category, truth, truth))
    monitor, found = calibrated(networks, [Held(Sequence(recording, ()))], Here(), looks=2)
    assert 0 < found.correct.mean() < 1
    assert len(found.features) == len(found.correct)
    assert isinstance(monitor.belief, Persistence)
    assert 0 < monitor.doubt_below < monitor.trust_above < 1
    assert HealthMonitor.calibrated(monitor.calibration) == monitor
