"""docs/wire-contract.md says what the service does, and its example runs."""

import re
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

from prometheus_client.parser import text_string_to_metric_families

from service.liveness import CloseReason
from service.rejections import FrameRejectedError, RequestRejectedError
from service.results import Event, EventKind, PartPose, Result, Timing
from service.settings import Settings
from tests.service.support import Running

TEXT = (Path(__file__).parents[2] / "docs" / "wire-contract.md").read_text(encoding="utf-8")


def test_every_reason_is_listed_with_its_status() -> None:
    for kind in (*FrameRejectedError.__subclasses__(), *RequestRejectedError.__subclasses__()):
        (row,) = re.findall(rf"^\| `{kind.reason}` \| (.*?) \|", TEXT, re.MULTILINE)
        assert str(kind.status) in row or row == "Zenoh only"


def test_every_field_kind_and_setting_is_listed() -> None:
    for name in [entry.name for message in (Result, Event, PartPose, Timing) for entry in fields(message)]:
        assert re.search(rf"[`.]{name}[`.\[]", TEXT), name
    for word in (*EventKind, *CloseReason):
        assert f"`{word}`" in TEXT, word
    for name in Settings.model_fields:
        assert f"`CAPTRA_{name.upper()}`" in TEXT, name


def test_every_field_of_the_rest_api_is_listed(service: Running) -> None:
    named = set(re.findall(r"\w+", " ".join(re.findall(r"`([^`\n]+)`", TEXT))))
    schemas = service.http.get("/openapi.json").json()["components"]["schemas"]
    fields = {(name, field) for name, schema in schemas.items() for field in schema.get("properties", {})}
    assert len(fields) > 50
    assert {(name, field) for name, field in fields if field not in named} == set()


def test_every_metric_of_ours_is_listed(service: Running) -> None:
    families = text_string_to_metric_families(service.http.get("/metrics").text)
    ours = {f"{family.name}_total" if family.type == "counter" else family.name for family in families}
    named = set(re.findall(r"`(captra_\w+)", TEXT))
    assert {name for name in ours if name.startswith("captra_") and not name.endswith("_created")} == named


def test_links_lead_to_headings() -> None:
    headings = {heading.lower().replace(" ", "-") for heading in re.findall(r"^#+ (.*)$", TEXT, re.MULTILINE)}
    assert set(re.findall(r"\]\(#([\w-]+)\)", TEXT)) <= headings


def test_example_runs(service: Running) -> None:
    (example,) = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
    script = example.replace("http://127.0.0.1:8080", str(service.http.base_url))
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    assert "'name': 'mug'" in done.stdout
    assert service.http.get("/v1/sessions").json() == {"sessions": []}
