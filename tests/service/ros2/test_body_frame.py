import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from captra.geometry import matrix_from_quat_xyzw
from service.ros2.body_frame import body_quat_xyzw, body_size

UNIT = st.lists(st.floats(-1, 1), min_size=4, max_size=4).filter(lambda values: np.linalg.norm(values) > 0.1)


@given(UNIT, st.tuples(*[st.floats(0.01, 1)] * 3))
def test_z_is_up_x_stays_forward_and_the_box_stays_where_it_is(
    values: list[float], size: tuple[float, float, float]
) -> None:
    quat_xyzw = tuple((np.array(values) / np.linalg.norm(values)).tolist())
    part, body = matrix_from_quat_xyzw(np.array(quat_xyzw)), matrix_from_quat_xyzw(np.array(body_quat_xyzw(quat_xyzw)))
    np.testing.assert_allclose(body[:, 0], part[:, 0], atol=1e-9)
    np.testing.assert_allclose(body[:, 2], part[:, 1], atol=1e-9)  # up
    np.testing.assert_allclose(body[:, 1], np.cross(body[:, 2], body[:, 0]), atol=1e-9)  # left
    corners = np.array(np.meshgrid(*[[-0.5, 0.5]] * 3)).reshape(3, -1)
    box, same = part @ (corners.T * size).T, body @ (corners.T * body_size(size)).T
    np.testing.assert_allclose(np.sort(box, axis=1), np.sort(same, axis=1), atol=1e-9)
