"""From the camera that a client describes to one that images are read with."""

from captra.depth_images import Intrinsics
from service import camera
from service.rejections import InvalidRequestError, UnsupportedOptionError
from service.rest.inputs import Camera


def camera_of(body: Camera) -> camera.Camera:
    """The camera.

    Raises:
        UnsupportedOptionError: it has distortion.
        InvalidRequestError: it has a width without a height, or the other way round.
    """
    if any(body.distortion):
        raise UnsupportedOptionError(
            "depth images with distortion are not read: rectify them first (as image_proc does), "
            "and give the intrinsics of the rectified images"
        )
    if (body.width is None) != (body.height is None):
        raise InvalidRequestError("/body/camera: give width and height together, or neither")
    return camera.Camera(Intrinsics(body.fx, body.fy, body.cx, body.cy), body.metres_per_unit, body.width, body.height)
