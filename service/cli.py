"""The `serve` command."""

import logging
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

HELP_CONFIG = "TOML file of settings; CAPTRA_* variables win over it."


def serve(
    config: Annotated[Path | None, typer.Option(help=HELP_CONFIG)] = None,
    host: Annotated[str | None, typer.Option(help="Interface of the REST API (CAPTRA_HTTP_HOST).")] = None,
    port: Annotated[int | None, typer.Option(help="Port of the REST API (CAPTRA_HTTP_PORT).")] = None,
    zenoh_listen: Annotated[
        list[str] | None, typer.Option(help="Endpoint of the Zenoh router, may be repeated (CAPTRA_ZENOH_LISTEN).")
    ] = None,
    ros2: Annotated[
        bool | None, typer.Option("--ros2/--no-ros2", help="Be a node of ROS 2 as well (CAPTRA_ROS2).")
    ] = None,
    models_dir: Annotated[Path | None, typer.Option(help="Folder of model bundles (CAPTRA_MODELS_DIR).")] = None,
) -> None:
    """Serve poses: REST on port 8080, an embedded Zenoh router on port 7447, both on loopback unless told otherwise.

    Stops on SIGTERM or Ctrl-C, after the frames in hand.

    Example: `captra serve --port 8090 --zenoh-listen tcp/127.0.0.1:7448`
    """
    with ending_on_sigterm():
        from pydantic import ValidationError
        from pydantic_settings import SettingsError

        from service.http_server import PortInUseError
        from service.run import run
        from service.security.wiring import ExposedError
        from service.setting_mistakes import complaint_of_syntax, complaints, mistyped
        from service.settings import MalformedConfigError, load_settings
        from service.store import StoreError
        from service.transport import TransportError

    options = {
        "http_host": host,
        "http_port": port,
        "zenoh_listen": zenoh_listen or None,
        "ros2": ros2,
        "models_dir": models_dir,
    }
    for doubt in mistyped(os.environ):
        typer.echo(f"captra serve: {doubt}", err=True)
    try:
        run(load_settings(config, {name: value for name, value in options.items() if value is not None}))
    except ValidationError as error:
        for complaint in complaints(error):
            typer.echo(f"captra serve: {complaint}", err=True)
        raise typer.Exit(2) from None
    except SettingsError as error:
        typer.echo(f"captra serve: {complaint_of_syntax(error)}", err=True)
        raise typer.Exit(2) from None
    except (ExposedError, FileNotFoundError, MalformedConfigError) as error:
        typer.echo(f"captra serve: {error}", err=True)
        raise typer.Exit(2) from None
    except (PortInUseError, StoreError, TransportError) as error:
        typer.echo(f"captra serve: {error}", err=True)
        raise typer.Exit(1) from None
    logging.shutdown()
    sys.stdout.flush()
    os._exit(0)  # all is closed; an interpreter that takes itself apart on a busy machine may take half a minute


@contextmanager
def ending_on_sigterm() -> Iterator[None]:
    """While there is nothing to finish yet, SIGTERM ends the process; the first of a container would not heed it."""
    before = signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
