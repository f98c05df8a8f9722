"""What a benchmark that tests something says at its end."""

from collections.abc import Sequence

from rich.console import Console
from rich.table import Table

Line = tuple[str, str, bool]
"""What, what was measured, whether it holds."""


def tell(console: Console, lines: Sequence[Line]) -> int:
    """Print a table of all lines; the exit status, 0 only if every line holds."""
    table = Table("what", "measured", "holds")
    for what, measured, holds in lines:
        table.add_row(what, measured, "yes" if holds else "NO")
    console.print(table)
    return int(not all(holds for *_, holds in lines))
