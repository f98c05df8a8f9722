"""What is wrong with settings, told so that it can be mended."""

import re
from collections.abc import Iterable, Iterator
from difflib import get_close_matches

from pydantic import ValidationError
from pydantic_settings import SettingsError

from service.settings import CONFIG_VARIABLE, Settings

PREFIX = "CAPTRA_"
OF_CLIENTS = {"URL", "CA_FILE", "API_KEY", "CLIENT_CERT", "CLIENT_KEY"}
"""Variables that clients on the same machine read; one of them looks much like a setting."""


def complaints(error: ValidationError) -> Iterator[str]:
    """A line for each value that cannot be used."""
    for entry in error.errors():
        name = ".".join(str(step) for step in entry["loc"])
        if entry["type"] == "extra_forbidden" and name.count(".") == 0:
            yield f"there is no setting {name}{suggestion(name.lower())}"
        elif name:
            yield f"setting {name}: {entry['msg']} (variable {PREFIX}{name.partition('.')[0].upper()})"
        else:
            yield entry["msg"]


def complaint_of_syntax(error: SettingsError) -> str:
    """A variable that is no JSON where JSON is needed."""
    field = re.search(r'field "(\w+)"', str(error))
    if field is None:
        return str(error)
    example = '["mug", "can"]' if field[1] == "preload" else '["tcp/127.0.0.1:7447"]'
    return f"{PREFIX}{field[1].upper()} is no JSON: write a list like {example}, with the quotation marks"


def mistyped(variables: Iterable[str]) -> Iterator[str]:
    """Variables that nobody reads although they look like settings."""
    others = {CONFIG_VARIABLE, *(PREFIX + name for name in OF_CLIENTS)}
    for variable in sorted(set(variables) - others):
        name = variable.removeprefix(PREFIX).lower()
        if variable.startswith(PREFIX) and name not in Settings.model_fields and (hint := suggestion(name)):
            yield f"{variable} is no setting{hint}"


def suggestion(name: str) -> str:
    """The setting that a name looks like, if it does."""
    close = get_close_matches(name, Settings.model_fields, n=1, cutoff=0.8)
    return f": did you mean {close[0]}?" if close else ""
