"""Single pictures of the camera with detected hands and signs drawn in."""

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.errors import PinelError


class Pictures:
    """Returns one picture per request; the camera is on while a client requests pictures."""

    def __init__(self, camera: CameraClient) -> None:
        self._camera = camera

    def next(self) -> bytes:
        """Returns the next picture, as JPEG.

        Raises:
            PinelError: the problem of the camera, such as `camera_missing`.
        """
        previews = self._camera.previews(annotated=True)
        try:
            picture = next(previews, None)
        finally:
            previews.close()
        if picture is None:
            raise self._camera.state.problem or PinelError("camera_no_picture")
        return picture
