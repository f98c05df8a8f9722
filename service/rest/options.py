"""From the options that a client asks for to those of a track, refusing what its category does not have."""

from collections.abc import Mapping

from captra.categories import Category
from service.rejections import InvalidRequestError, Mistake
from service.rest.inputs import NewSession
from service.rest.vectors import Vector3
from service.track_options import Prediction, Smoothing, TrackOptions

SHORTEST_AXIS = 1e-6


def track_options_of(body: NewSession, category: Category, prediction: Prediction) -> TrackOptions:
    """The options of a new session; `prediction` is the service's own choice.

    Raises:
        InvalidRequestError: the category has no such joint, or an axis has no direction.
    """
    smooth = body.smoothing
    return TrackOptions(
        prediction=body.prediction or prediction,
        smoothing=None
        if smooth is None
        else Smoothing(smooth.cutoff_hz, smooth.translation_gain, smooth.rotation_gain),
        joint_axes=None if body.joint_axes is None else joint_axes_of(body.joint_axes, category),
    )


def joint_axes_of(axes: Mapping[str, Vector3], category: Category) -> dict[str, tuple[float, float, float]]:
    """Axes by joint.

    Raises:
        InvalidRequestError: the category has no such joint, or an axis has no direction.
    """
    known = [joint.name for joint in category.joints]
    for name, axis in axes.items():
        if name not in known:
            raise InvalidRequestError(
                Mistake(
                    "/body/joint_axes",
                    f"{category.name} has no joint {name[:100]!r}; it has {', '.join(known) or 'none'}",
                )
            )
        if max(abs(value) for value in axis) < SHORTEST_AXIS:
            raise InvalidRequestError(
                Mistake(f"/body/joint_axes/{name}", "the axis has no direction: give a vector of length 1")
            )
    return {name: (x, y, z) for name, (x, y, z) in axes.items()}
