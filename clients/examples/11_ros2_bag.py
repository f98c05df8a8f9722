"""Track an object through a bag of ROS 2, an MCAP file with PointCloud2 as `ros2 bag record` writes it, without ROS.

Write down where the object is in the first cloud, in session.json, as for POST /v1/sessions:

    {
      "category": "mug",
      "parts": [{"rotation": {"quat_xyzw": [1, 0, 0, 0]}, "translation": [0.02, 0.05, 0.6], "size": [0.12, 0.1, 0.08]}],
      "record": true
    }

This mug stands upright before a camera's optical frame, whose y points down, with its handle to the right; what was
tracked is recorded by the service. Start one first (`make serve`), then run

    python clients/examples/11_ros2_bag.py bag.mcap /camera/depth/points session.json
"""

import sys
from pathlib import Path

import orjson
from mcap.reader import make_reader

from clients import RequestRefusedError
from clients.rest import RestApi
from clients.results import parse_result

bag, topic, first = sys.argv[1:]
api = RestApi()
session_id = api.post_session(orjson.loads(Path(first).read_bytes()))["session_id"]
seq = -1
with Path(bag).open("rb") as file:
    for seq, (*_, message) in enumerate(make_reader(file).iter_messages(topics=[topic])):
        try:
            answer = api.post_frame(session_id, message.data, "application/cdr", seq=seq, stamp_ns=message.log_time)
        except RequestRefusedError as refusal:  # the session is as it was
            print(f"{seq}: {refusal}")
            continue
        result = parse_result(answer)
        for part in result.parts:
            x, y, z = part.translation
            print(f"{result.stamp_ns} {result.frame_id}: {part.name} {result.state} at {x:.3f} {y:.3f} {z:.3f} m")
api.delete(session_id)
api.close()
if seq < 0:
    sys.exit(f"{bag} has no messages on {topic}: `ros2 bag info` lists its topics")
