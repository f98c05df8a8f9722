"""A Dockerfile, read: the instructions that ours uses, and no others."""

import json
import re
import shlex
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

BASE_STAGE = re.compile(r"(?P<base>\S+)(?: AS (?P<name>\S+))?")


class DockerfileError(ValueError):
    """An instruction that is not understood here."""


@dataclass(frozen=True)
class Copy:
    """Files into the stage."""

    sources: tuple[str, ...]
    """Paths in the project, or in the stage that `stage` names."""
    target: str
    """Path in this stage; ends with a slash where it is a folder that files go into."""
    stage: str | None = None
    """Where they come from, if from another stage."""


@dataclass(frozen=True)
class Run:
    """A command in the stage, as root."""

    command: str
    """For /bin/sh."""


@dataclass
class Stage:
    """From one FROM to the next; filled while the file is read."""

    base: str
    """An image, or the name of an earlier stage."""
    name: str
    """Its own; empty for the last one."""
    steps: list[Copy | Run] = field(default_factory=list)
    """What is done, in order."""
    environment: dict[str, str] = field(default_factory=dict)
    """ARG and ENV."""
    user: str = "0:0"
    """Numbers of user and group that the container runs as."""
    volumes: list[str] = field(default_factory=list)
    """Folders that may be written to."""
    entrypoint: list[str] = field(default_factory=list)
    """What runs."""
    command: list[str] = field(default_factory=list)
    """Its arguments, where none are given."""
    health_check: list[str] = field(default_factory=list)
    """Ends with status 0 when the container is healthy."""


def read(text: str, arguments: Mapping[str, str]) -> list[Stage]:
    """The stages of a Dockerfile, with `--build-arg` values.

    Raises:
        DockerfileError: it holds something that is not understood here.
    """
    stages: list[Stage] = []
    defaults: dict[str, str] = {}
    for word, rest in instructions(text):
        if word == "FROM":
            match = BASE_STAGE.fullmatch(rest)
            if match is None:
                raise DockerfileError(f"FROM {rest}")
            stages.append(Stage(match["base"], match["name"] or ""))
        elif word == "ARG" and not stages:
            name, _, default = rest.partition("=")
            defaults[name] = arguments.get(name, default)
        elif word == "ARG":
            stages[-1].environment[rest] = defaults[rest]
        else:
            add(stages[-1], word, rest)
    return stages


def instructions(text: str) -> Iterator[tuple[str, str]]:
    """Each instruction with the rest of its line, continued lines in one."""
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    for line in re.sub(r"\\\n\s*", "", "\n".join(lines)).splitlines():
        word, _, rest = line.partition(" ")
        yield word, rest.strip()


def add(stage: Stage, word: str, rest: str) -> None:
    """Take one instruction in."""
    match word:
        case "COPY":
            stage.steps.append(copy_of(rest))
        case "RUN":
            stage.steps.append(Run(rest))
        case "ENV":
            stage.environment |= dict(pair.split("=", 1) for pair in shlex.split(rest))
        case "USER":
            stage.user = rest
        case "VOLUME":
            stage.volumes.append(rest)
        case "ENTRYPOINT":
            stage.entrypoint = json.loads(rest)
        case "CMD":
            stage.command = json.loads(rest)
        case "HEALTHCHECK":
            stage.health_check = json.loads(rest.partition("CMD ")[2])
        case "EXPOSE":
            pass
        case _:
            raise DockerfileError(f"{word} {rest}")


def copy_of(rest: str) -> Copy:
    """The arguments of COPY."""
    words = rest.split()
    stage = words.pop(0).removeprefix("--from=") if words[0].startswith("--from=") else None
    if any(word.startswith("--") for word in words):
        raise DockerfileError(f"COPY {rest}")
    *sources, target = words
    return Copy(tuple(sources), target, stage)
