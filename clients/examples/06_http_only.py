"""Track by HTTP alone, with nothing of captra installed but the address: for languages and machines without Zenoh.

    python clients/examples/06_http_only.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz

Every call is shown as it goes over the wire; docs/wire-contract.md has all fields. Zenoh is faster and drops old clouds
when the service falls behind; by HTTP every cloud is waited for.
"""

import os
import sys

import httpx
import numpy as np

stored = np.load(sys.argv[1])  # an .npz archive; points are int16 multiples of 0.1 mm, just as they go over the wire
parts = [
    {"rotation": {"matrix": rotation.tolist()}, "translation": translation.tolist(), "size": size.tolist()}
    for rotation, translation, size in zip(
        stored["init_rotation"], stored["init_translation"], stored["init_size"], strict=True
    )
]

with httpx.Client(base_url=os.environ.get("CAPTRA_URL", "http://127.0.0.1:8080"), timeout=30) as http:
    answer = http.post("/v1/sessions", json={"category": str(stored["category"]), "parts": parts})
    if not answer.is_success:
        sys.exit(answer.json()["detail"])
    opened = answer.json()
    path = f"/v1/sessions/{opened['session_id']}"
    starts = stored["offsets"]
    for seq, stamp_ns in enumerate(stored["stamp_ns"]):
        cloud = stored["points"][starts[seq] : starts[seq + 1]].astype("<i2").tobytes()
        answer = http.post(
            f"{path}/frames",
            params={"seq": seq, "stamp_ns": int(stamp_ns)},
            content=cloud,
            headers={"Content-Type": "application/vnd.captra.cloud.i16"},
        )
        if answer.is_success:
            result = answer.json()
            print(seq, result["state"], result["parts"][0]["translation"])
        else:
            print(seq, answer.json()["reason"], answer.json()["detail"])  # the session is as it was
    http.delete(path)
