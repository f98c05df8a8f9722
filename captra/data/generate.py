"""`captra generate`: training views in simulated scenes, shard by shard."""

from pathlib import Path
from typing import Annotated

import typer


def generate(
    category: Annotated[str, typer.Option(help="What to show, e.g. mug.")],
    count: Annotated[int, typer.Option(help="Views in all.", min=1)],
    seed: Annotated[int, typer.Option(help="Views depend on it and on their number only.", min=0)],
    out: Annotated[Path, typer.Option(help="Folder of the shards; training reads .campaign/views/CATEGORY/train.")],
    meshes: Annotated[
        Path | None, typer.Option(help="Library of objects with an INDEX.json: those for training are mixed in.")
    ] = None,
    mesh_fraction: Annotated[
        float, typer.Option(help="Largest share of views of library objects.", min=0, max=1)
    ] = 0.35,
    held: Annotated[
        float,
        typer.Option(help="How often a hand holds the object; less for some categories.", min=0, max=1),
    ] = 0.45,
) -> None:
    """Simulate views of procedural objects to train on; interrupt it whenever you like, the same command goes on.

    Shards appear one by one, so that training may begin before all are there.

    Example: captra generate --category mug --count 12000 --seed 2 --out .campaign/views/mug/train
    """
    import time

    from captra.categories import get_category
    from captra.data.generation import generate_views, keep_for, write_sources
    from captra.data.meshes import load_meshes, shape_source
    from captra.data.views import ViewOptions
    from captra.outputs import check_folder

    name = get_category(category).name
    library = load_meshes(meshes, name, "train") if meshes else ()
    draw_shape = shape_source(name, library, mesh_fraction)
    sources = {mesh.name: str(mesh.credit.checked(mesh.name)) for mesh in library}
    check_folder(out)
    keep_for(name, out)
    write_sources(out, sources)
    started = time.monotonic()

    def report(done: int) -> None:
        typer.echo(f"{name}: {done}/{count} views, {time.monotonic() - started:.0f} s")

    try:
        generate_views(name, count, seed, out, draw_shape, ViewOptions(held_fraction=held), progress=report)
    except KeyboardInterrupt:
        typer.echo("stopped; run the same command to go on")


if __name__ == "__main__":
    typer.run(generate)
