"""Command line: simulate training views in the background.

Example: python -m captra.data.generate --category mug --count 8000 --seed 1 --out views/mug/train
"""

import argparse
import sys
import time
from pathlib import Path

from captra.data.generation import generate_views, write_sources
from captra.data.meshes import load_meshes, shape_source


def main(arguments: list[str] | None = None) -> None:
    """Write shards until `--count` views are there; run it again to go on after an interruption."""
    parser = argparse.ArgumentParser(description=main.__doc__, epilog=__doc__)
    parser.add_argument("--category", required=True, help="e.g. mug")
    parser.add_argument("--count", type=int, required=True, help="views in all")
    parser.add_argument("--seed", type=int, required=True, help="views depend on the seed and their number only")
    parser.add_argument("--out", type=Path, required=True, help="folder of the shards")
    parser.add_argument(
        "--meshes", type=Path, help="library of objects with an INDEX.json, to mix in those for training"
    )
    parser.add_argument("--mesh-fraction", type=float, default=0.35, help="largest share of views of library objects")
    options = parser.parse_args(arguments)
    meshes = load_meshes(options.meshes, options.category, "train") if options.meshes else ()
    draw_shape = shape_source(options.category, meshes, options.mesh_fraction)
    write_sources(options.out, {mesh.name: mesh.licence for mesh in meshes})
    started = time.monotonic()

    def report(done: int) -> None:
        sys.stdout.write(f"{options.category}: {done}/{options.count} views, {time.monotonic() - started:.0f} s\n")
        sys.stdout.flush()

    try:
        generate_views(options.category, options.count, options.seed, options.out, draw_shape, progress=report)
    except KeyboardInterrupt:
        sys.stdout.write("stopped; run the same command to go on\n")


if __name__ == "__main__":
    main()
