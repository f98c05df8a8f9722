"""Malformed clouds over HTTP to one session of a real service, as fast as they go, while neighbours are tracked.

python -m benchmarks.flood --clouds 100000

Ends with status 0 only if every cloud was refused, not one met a defect, the process has not ended, and no neighbour
was given an answer that is not its own.
"""

import re
import sys
import time
from collections import Counter
from contextlib import ExitStack, closing
from typing import Annotated

import numpy as np
import typer
from rich.console import Console

from benchmarks.faults import FLOODED, Flood, metrics
from benchmarks.fleet import ANSWER_WITHIN_S, WRONG_M, mug_service, open_fleet, play_round
from benchmarks.verdict import tell
from captra.bench.machine import this_machine
from clients.rest import RestApi

PAUSE_S = 0.5
"""Between rounds of the neighbours, so that most of the machine is left to the flood."""
CAMERA = {"fx": 590, "fy": 590, "cx": 320, "cy": 240, "width": 640, "height": 480}
"""The flooded session reads images too."""
REFUSED = re.compile(r'captra_(?:frames|requests)_rejected_total\{reason="(?P<reason>[^"]+)"\}')


def refusals(url: str) -> Counter[str]:
    """How many of each reason the service has counted."""
    found = ((REFUSED.match(name), int(count)) for name, count in metrics(url).items())
    return Counter({match["reason"]: count for match, count in found if match is not None})


def main(
    clouds: Annotated[int, typer.Option(help="How many malformed ones.", min=1)] = 100_000,
    neighbours: Annotated[int, typer.Option(help="Sessions beside the flooded one.", min=1)] = 4,
) -> None:
    """Flood one session, and look at all of them."""
    console = Console(width=110)
    console.print(this_machine())
    with ExitStack() as resources:
        service = resources.enter_context(mug_service(neighbours + 1))
        with closing(RestApi(service.url)) as api:
            flooded = api.post_session(FLOODED | {"camera": CAMERA})["session_id"]
        fleet = resources.enter_context(open_fleet(service.url, neighbours))
        before, started_s = refusals(service.url), time.monotonic()
        with Flood(service.url, flooded, rate_hz=np.inf) as flood:
            while flood.sent < clouds and service.is_running:
                play_round(fleet, ANSWER_WITHIN_S)
                time.sleep(PAUSE_S)
        passed_s = time.monotonic() - started_s
        alive = service.is_running
        counted = refusals(service.url) - before if alive else Counter()
    errors_m = np.concatenate([each.errors_m for each in fleet])
    wrong, refused = int((errors_m > WRONG_M).sum()), counted.total()
    lines = [
        ("malformed clouds", f"{flood.sent}, {flood.sent / passed_s:.0f} a second", flood.sent >= clouds),
        ("refused and counted", f"{refused}", refused == flood.sent),
        *((f"  {reason}", f"{count}", True) for reason, count in sorted(counted.items())),
        ("met a defect", f"{flood.crashes}", flood.crashes == 0),
        ("the service still runs", "yes" if alive else "no", alive),
        (f"answers to {neighbours} neighbours", f"{len(errors_m)}", len(errors_m) > 0),
        (f"of them more than {WRONG_M * 100:.0f} cm from their own truth", f"{wrong}", wrong == 0),
    ]
    sys.exit(tell(console, lines))


if __name__ == "__main__":
    typer.run(main)
