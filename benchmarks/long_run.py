"""Whether memory stays flat over many frames: bytes in, JSON out, in one process, without HTTP and Zenoh around it.

python -m benchmarks.long_run --frames 100000

The networks are those that ship, at a small number of points, so that frames are cheap: what a frame allocates does not
depend on it. Ends with status 0 only if memory has not grown by more than the limit after the first tenth.
"""

import gc
import os
import sys
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from captra.data.recordings import load_recording
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import NoPointsError, Profile
from clients.demo import COFFEE_MUG
from service.bundles import engine_of
from service.codecs.packed import CLOUD_F32, packed_codecs
from service.envelopes import Envelope, pack_attachment
from service.results import part_poses

SMALL = Profile("small", 128, (32, 8), ((4, 8, 16), (8, 16)))
ROWS = 10
LIMIT_MIB = 8.0


def main(
    frames: Annotated[int, typer.Option(help="So many.")] = 100_000,
    provider: Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")] = "cpu",
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = Path("models"),
) -> None:
    """Track the bundled mug again and again and print memory."""
    recording = load_recording(COFFEE_MUG)
    networks = OnnxNetworks.load(models / "mug", SMALL, provider)
    tracker = engine_of(networks).start(recording.init)
    codec = next(each for each in packed_codecs(1_000_000) if each.encoding == CLOUD_F32)
    payloads = [np.ascontiguousarray(cloud, "<f4").tobytes() for cloud in recording.clouds]
    attachment = pack_attachment(0, 0)
    memory_mib, written = [], 0
    for frame in range(frames):
        envelope = Envelope(CLOUD_F32, bytes(bytearray(payloads[frame % len(payloads)])), attachment, 0.0)
        if frame % len(payloads) == 0:
            tracker.reset(recording.init)
        try:
            result = tracker.step(codec.open(envelope).observe())
        except NoPointsError:
            tracker.reset(recording.init)
            continue
        written += len(str(part_poses(result.pose, networks.category)))
        if (frame + 1) % max(1, frames // ROWS) == 0:
            gc.collect()
            memory_mib.append(resident_mib())
            print(f"{frame + 1:>9} frames: {memory_mib[-1]:.1f} MiB", flush=True)
    grown = max(memory_mib[1:], default=memory_mib[0]) - memory_mib[0]
    print(f"grown by {grown:.1f} MiB after the first tenth; {written / 1e6:.0f} MB of poses written")
    sys.exit(grown > LIMIT_MIB)


def resident_mib() -> float:
    """Memory that this process holds."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


if __name__ == "__main__":
    typer.run(main)
