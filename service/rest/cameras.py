"""From the camera that a client describes to one that images are read with."""

from captra.depth_images import Intrinsics
from service import camera
from service.rejections import InvalidRequestError, Mistake, UnsupportedOptionError
from service.rest.inputs import Camera


def camera_of(body: Camera, max_points: int) -> camera.Camera:
    """The camera; a frame may have `max_points` pixels.

    Raises:
        UnsupportedOptionError: it has distortion.
        InvalidRequestError: it has a width without a height, or the other way round, or too many pixels.
    """
    if any(body.distortion):
        raise UnsupportedOptionError(
            "depth images with distortion are not read: rectify them first (as image_proc does), "
            "and give the intrinsics of the rectified images"
        )
    if (body.width is None) != (body.height is None):
        raise InvalidRequestError(Mistake("/body/camera", "give width and height together, or neither"))
    if (body.width or 0) * (body.height or 0) > max_points:
        raise InvalidRequestError(
            Mistake(
                "/body/camera",
                f"images of {body.width} × {body.height} pixels are over the limit of {max_points}: "
                "send every other row and column with fx, fy, cx, cy halved, or raise CAPTRA_MAX_POINTS",
            )
        )
    return camera.Camera(Intrinsics(body.fx, body.fy, body.cx, body.cy), body.metres_per_unit, body.width, body.height)
