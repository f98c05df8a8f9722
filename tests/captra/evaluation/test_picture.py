from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.image import imread

from captra.evaluation.picture import before_and_after, cloud_from_depth, draw_pose, project
from captra.geometry import Pose

K = np.array([[500.0, 0, 160], [0, 500, 120], [0, 0, 1]])


def test_points_of_a_depth_image_project_back_to_their_pixels() -> None:
    depth_mm = np.zeros((240, 320), np.uint16)
    depth_mm[100, 200], depth_mm[30, 40] = 800, 1500
    points = cloud_from_depth(depth_mm, K)
    assert len(points) == 2, "pixels without a depth give no point"
    np.testing.assert_allclose(points[:, 2], [1.5, 0.8])
    np.testing.assert_allclose(project(points, K), [[40, 30], [200, 100]], atol=1e-3)


def test_a_box_is_drawn_where_it_is_seen() -> None:
    pose = Pose.from_size(np.eye(3)[None], np.array([[0.1, 0, 1.0]]), np.array([[0.2, 0.1, 0.01]]))
    axes = Figure().subplots()
    draw_pose(axes, pose, K, "orange")
    edges = [line for line in axes.lines if line.get_color() == "orange"]
    assert len(edges) == 12
    drawn = np.concatenate([line.get_xydata() for line in edges])
    np.testing.assert_allclose(drawn.mean(axis=0), [160 + 50, 120], atol=0.5)
    np.testing.assert_allclose(np.ptp(drawn, axis=0), [100, 50], rtol=0.02)
    assert len(axes.lines) == 15, "and three axes"


@pytest.mark.parametrize("count", [1, 2])
def test_one_panel_a_pose_around_the_object(count: int, tmp_path: Path) -> None:
    pose = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0, 1.0]]), np.full((1, 3), 0.1))
    poses = {f"pose {i}": (pose, "lime") for i in range(count)}
    depth_mm = np.full((240, 320), 1000, np.uint16)
    before_and_after(depth_mm, K, poses, tmp_path / "picture.png")
    picture = imread(tmp_path / "picture.png")
    assert picture.shape[1] == 520 * count
    lime = (picture[..., 1] > 0.95) & (picture[..., 0] < 0.1) & (picture[..., 2] < 0.1)
    columns = np.flatnonzero(lime.any(axis=0))
    assert len(columns)
    assert columns.max() // 520 == count - 1
