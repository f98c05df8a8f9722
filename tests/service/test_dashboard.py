"""The Grafana dashboard asks for what /metrics really exposes, and leaves none of it out."""

import json
import re
from pathlib import Path

from prometheus_client.parser import text_string_to_metric_families

from tests.service.support import Running, blob, f32

DASHBOARD = json.loads((Path(__file__).parents[2] / "deploy" / "grafana-dashboard.json").read_text())
EXPRESSIONS = [target["expr"] for panel in DASHBOARD["panels"] for target in panel["targets"]]


def asked() -> set[str]:
    return {name for expression in EXPRESSIONS for name in re.findall(r"\b(?:captra|process)_\w+", expression)}


def test_every_metric_it_shows_is_exposed_and_every_one_of_ours_is_shown(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    assert service.post_frame(session_id, f32(blob())).status_code == 200
    families = list(text_string_to_metric_families(service.http.get("/metrics").text))
    exposed = {sample.name for family in families for sample in family.samples}
    assert asked() <= exposed
    shown = {re.sub(r"_(total|bucket)$", "", name) for name in asked()}
    ours = {family.name for family in families if family.name.startswith("captra_")}
    assert {name for name in ours if not name.endswith("_created")} <= shown


def test_labels_it_groups_by_exist(service: Running) -> None:
    families = text_string_to_metric_families(service.http.get("/metrics").text)
    labels = {label for family in families for sample in family.samples for label in sample.labels} | {"le", "stage"}
    for expression in EXPRESSIONS:
        for group in re.findall(r"by \(([^)]*)\)", expression):
            assert set(group.split(", ")) <= labels


def test_panels_do_not_overlap() -> None:
    places = {(panel["gridPos"]["x"], panel["gridPos"]["y"]) for panel in DASHBOARD["panels"]}
    assert len(places) == len(DASHBOARD["panels"]) == len({panel["id"] for panel in DASHBOARD["panels"]})
