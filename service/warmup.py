"""The first frame before the first frame: kernels compiled, networks run once."""

import numpy as np

from captra.geometry import Pose
from service.networks import Engine


def warm_up(engine: Engine) -> None:
    """Track a made-up object for one frame in memory that can be written and for one in memory that cannot.

    Compiled kernels distinguish the two, and a cloud straight off the wire is a read-only view of its payload.
    """
    parts = engine.networks.category.num_parts
    pose = Pose.from_size(np.tile(np.eye(3), (parts, 1, 1)), np.zeros((parts, 3)), np.full((parts, 3), 0.1))
    cloud = np.random.default_rng(0).uniform(-0.05, 0.05, (2 * engine.networks.profile.points, 3)).astype(np.float32)
    for writeable in (True, False):
        cloud.setflags(write=writeable)
        engine.start(pose).step(cloud)
