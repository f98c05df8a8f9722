"""The console script: collects the subcommands that packages register in the entry-point group `captra.commands`."""

import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib.metadata import EntryPoint, PackageNotFoundError, entry_points, requires
from typing import Any

import typer

from captra.errors import UserError

GROUP = "captra.commands"
DISTRIBUTION = "captra"
DISTRIBUTIONS = {"jwt": "pyjwt", "small_gicp": "small-gicp"}
"""Of modules that are not called like what brings them: only what is installed tells that by itself."""
REQUIREMENT_OF_EXTRA = re.compile(r"""(?P<name>[\w.-]+).*\bextra == ["'](?P<extra>[\w-]+)["']""")


def main(arguments: Sequence[str] | None = None) -> None:
    """Run `captra` with the given arguments, by default those of the process; always ends in SystemExit.

    Only the module of the command that is asked for gets imported, so that a missing extra stops no other command.
    """
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    registered = {entry.name: entry for entry in entry_points(group=GROUP)}
    asked = registered.get(next((argument for argument in arguments if not argument.startswith("-")), ""))
    if asked is None:
        app = build_app({name: available(entry) for name, entry in sorted(registered.items())})
        app(args=arguments, prog_name="captra")
        return
    try:
        build_app({asked.name: asked.load()})(args=arguments, prog_name="captra")
    except ModuleNotFoundError as error:
        explanation = explain(error, prefer=asked.module)
        if explanation is None:
            raise
        typer.echo(f"captra {asked.name}: {explanation}", err=True)
        sys.exit(2)
    except UserError as error:
        typer.echo(f"captra {asked.name}: {error}", err=True)
        sys.exit(1)


def available(entry: EntryPoint) -> Callable[..., Any]:
    """The command's function; where its module misses something, a stand-in whose help says what to install."""
    try:
        return entry.load()  # type: ignore[no-any-return]
    except ModuleNotFoundError as error:
        missing = explain(error, prefer=entry.module) or error

        def unavailable() -> None:  # for the help alone: a command that is asked for is loaded by itself
            raise NotImplementedError

        unavailable.__doc__ = f"Not available: {missing}"
        return unavailable


def build_app(commands: Mapping[str, Callable[..., Any]]) -> typer.Typer:
    """One Typer application of the given functions; a function's docstring is its help."""
    app = typer.Typer(
        add_completion=False,
        no_args_is_help=True,
        pretty_exceptions_enable=False,
        rich_markup_mode="markdown",
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback()(describe)
    for name, function in commands.items():
        app.command(name)(function)
    return app


def describe() -> None:
    """Track the pose of objects of known categories in point clouds, without a CAD model.

    Example: `captra demo`
    """


def explain(error: ModuleNotFoundError, prefer: str = "") -> str | None:
    """What to install for the missing module, or None where no extra of this project brings it.

    `prefer` is the module of a command: an extra that is called like its package comes first.
    """
    module = (error.name or "").partition(".")[0]
    missing = DISTRIBUTIONS.get(module, module)
    extras = extras_with(missing, _requirements())
    if not extras or missing == DISTRIBUTION:  # its own extras name each other; a module it lacks is a defect
        return None
    package = prefer.partition(".")[0]
    extra = package if package in extras else extras[0]
    return (
        f"needs {missing}, which is not installed. Install the extra that brings it: "
        f"pip install '.[{extra}]' in the project's folder"
    )


def extras_with(distribution: str, requirements: Iterable[str]) -> list[str]:
    """Names of the extras among `requirements` (as in wheel metadata) that bring a distribution."""
    matches = (REQUIREMENT_OF_EXTRA.match(requirement) for requirement in requirements)
    return [match["extra"] for match in matches if match and match["name"].lower() == distribution.lower()]


def _requirements() -> Iterable[str]:
    try:
        return requires(DISTRIBUTION) or ()
    except PackageNotFoundError:  # run from a source tree that was never installed
        return ()
