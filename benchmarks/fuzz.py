"""Fuzzes everything that decodes bytes of strangers, led by coverage, for a bounded time.

python -m benchmarks.fuzz --seconds 60              # needs atheris: pip install '.[fuzz]'

An input after which anything but a refusal is raised is left in the folder and printed; the status is not 0 then. Such
inputs belong into tests/service/codecs/test_decoding.py.
"""

import logging
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated

import typer

INSTRUMENTED = [
    "service.codecs",
    "service.ros2",
    "service.rest.forms",
    "rosbags",
    "PIL",
    "starlette",
    "python_multipart",
]
LONGEST_INPUT = 4096


def main(
    seconds: Annotated[int, typer.Option("--seconds", help="How long.")] = 60,
    found: Annotated[Path, typer.Option(help="Folder for inputs that are defects.")] = Path("found-by-fuzzing"),
) -> None:
    """Fuzz until the time is over or a defect is found."""
    try:
        import atheris
    except ImportError:
        sys.exit("benchmarks/fuzz.py needs atheris: pip install '.[fuzz]'")
    with atheris.instrument_imports(include=INSTRUMENTED):
        from benchmarks.decoding import decoder, seeds
    found.mkdir(exist_ok=True)
    logging.disable()  # what a parser of forms finds wrong is told by the refusal
    with TemporaryDirectory() as corpus:
        for number, seed in enumerate(seeds()):
            Path(corpus, f"seed-{number}").write_bytes(seed)
        chosen = {"max_total_time": seconds, "max_len": LONGEST_INPUT, "artifact_prefix": f"{found}/"}
        options = [f"-{name}={value}" for name, value in chosen.items()]
        decode = decoder().decode
        atheris.Setup([sys.argv[0], *options, corpus], decode)
        atheris.Fuzz()


if __name__ == "__main__":
    typer.run(main)
