"""The process, the bundles and the recordings that belong to the project, together."""

import json
import signal
from pathlib import Path

import httpx
import numpy as np
import pytest

from captra.data.recordings import load_recording
from captra.geometry import quat_xyzw_from_matrix
from tests.service.support import I16, Camera, free_endpoint, i16, inbox, zenoh_client
from tests.service.test_process import ENDS_WITHIN_S, ROOT, entry, process, stream

RECORDINGS = [
    path
    for path in sorted((ROOT / "recordings").glob("*.npz"))
    if (ROOT / "models" / path.name.split("__")[0]).is_dir()
]


@pytest.mark.skipif(not RECORDINGS, reason="no bundle in models/ has a recording in recordings/")
@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_recording_is_tracked_by_the_served_bundle(path: Path) -> None:
    recording, endpoint = load_recording(path), free_endpoint()
    first = recording.init
    parts = [
        {"rotation": {"quat_xyzw": quat_xyzw.tolist()}, "translation": translation.tolist(), "size": size.tolist()}
        for quat_xyzw, translation, size in zip(
            quat_xyzw_from_matrix(first.rotation), first.translation, first.size, strict=True
        )
    ]
    variables = {"CAPTRA_HTTP_PORT": "0", "CAPTRA_ZENOH_LISTEN": json.dumps([endpoint])}
    with process("-m", "service", **variables) as service:
        url = entry(stream(service.stderr), "serving")["http"]
        entry(stream(service.stderr), "ready")
        body = {"category": recording.category.name, "parts": parts}
        opened = httpx.post(f"{url}/v1/sessions", json=body, timeout=60).json()
        errors_m = []
        with zenoh_client(endpoint) as network:
            poses = inbox(network, opened["zenoh"]["pose"])
            camera = Camera(network, opened["zenoh"]["cloud"], I16)
            for frame, cloud in enumerate(recording.clouds):
                stamp_ns = int(recording.stamps_ns[frame])
                camera.put(i16(cloud), frame, stamp_ns)
                result = poses.message(frame)
                assert (result["seq"], result["stamp_ns"]) == (frame, stamp_ns)
                found = np.array([part["translation"] for part in result["parts"]])
                errors_m.append(np.linalg.norm(found - recording.translation[frame], axis=1).max())
        assert "libtorch" not in Path(f"/proc/{service.pid}/maps").read_text()
        service.send_signal(signal.SIGTERM)
        assert service.wait(ENDS_WITHIN_S) == 0
    diagonal_m = float(np.linalg.norm(recording.init.size, axis=1).max())
    assert np.median(errors_m) < max(0.05, 0.1 * diagonal_m), "5 cm, or a tenth of what is larger than half a metre"
