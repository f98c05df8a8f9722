"""`python -m service`: the same as `captra serve`."""

import typer

from service.cli import serve

typer.run(serve)
