"""Examples in the OpenAPI document."""

from pydantic.config import JsonDict, JsonValue

from service.codecs import CDR, CLOUD_F32, CLOUD_I16

SESSION_ID = "9f2c1e07ab34d658"
MUG_PART: JsonDict = {
    "rotation": {"quat_xyzw": [0.0, 0.7071068, 0.0, 0.7071068]},
    "translation": [0.02, -0.05, 0.61],
    "size": [0.12, 0.09, 0.08],
}
DEPTH_CAMERA: JsonDict = {"fx": 590.0, "fy": 590.0, "cx": 319.5, "cy": 239.5, "width": 640, "height": 480}
ROS2: JsonDict = {"points_topic": "/camera/depth/points", "name": "coffee_mug"}
RECORDING: JsonDict = {"name": f"mug_{SESSION_ID}", "size_bytes": 4_194_304, "finished": True}
MUG_RESULT: JsonDict = {
    "session_id": SESSION_ID,
    "seq": 7,
    "stamp_ns": 1_700_000_000_033_000_000,
    "frame_id": "camera_color_optical_frame",
    "state": "tracking",
    "confidence": 0.97,
    "parts": [
        {
            "name": "mug",
            "translation": [0.021, -0.049, 0.612],
            "quat_xyzw": [0.0, 0.7071068, 0.0, 0.7071068],
            "size": [0.118, 0.091, 0.08],
        }
    ],
    "joints": [],
    "looks": 3,
    "timing_ms": {"queue": 0.2, "sample": 3.1, "infer": 21.4, "solve": 0.9, "total": 26.0},
}
STREAM_KEYS: JsonDict = {
    "cloud": f"captra/default/sessions/{SESSION_ID}/cloud",
    "pose": f"captra/default/sessions/{SESSION_ID}/pose",
    "event": f"captra/default/sessions/{SESSION_ID}/event",
    "endpoints": ["tcp/127.0.0.1:7447"],
    "secret": None,
}
ENCODINGS: list[JsonValue] = [CLOUD_F32, CLOUD_I16, CDR]
OPENED: JsonDict = {
    "session_id": SESSION_ID,
    "category": "mug",
    "state": "tracking",
    "expires_after_s": 300.0,
    "encodings": ENCODINGS,
    "zenoh": STREAM_KEYS,
    "ros2": {
        "points_topic": "/camera/depth/points",
        "detections_topic": "/captra/coffee_mug/detections",
        "joint_states_topic": None,
        "frames": ["coffee_mug/mug"],
    },
}
SESSION: JsonDict = OPENED | {
    "profile": "realtime",
    "frame_id": "camera_color_optical_frame",
    "idle_timeout_s": 300.0,
    "record": False,
    "masks": None,
    "camera": None,
    "prediction": "constant-velocity",
    "smoothing": None,
    "joint_axes": None,
    "started_from": [
        {
            "rotation": {"matrix": [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]},
            "translation": [0.02, -0.05, 0.61],
            "size": [0.12, 0.09, 0.08],
        }
    ],
    "client": True,
    "created_ns": 1_700_000_000_000_000_000,
    "counters": {
        "received": 9,
        "processed": 8,
        "dropped": 0,
        "rejected": 1,
        "rejected_by_reason": {"empty-cloud": 1},
    },
    "last_result": MUG_RESULT,
}
