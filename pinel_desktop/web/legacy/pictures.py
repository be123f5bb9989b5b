"""The camera's picture with the hands and the signs that it sees, one after another."""

from pinel_desktop.camera.client import CameraClient
from pinel_desktop.errors import PinelError


class Pictures:
    """Pictures for who asks for the next one; the camera is on as long as somebody does."""

    def __init__(self, camera: CameraClient) -> None:
        self._camera = camera

    def next(self) -> bytes:
        """The next picture, as JPEG.

        Raises PinelError that says what is wrong with the camera, such as `camera_missing`.
        """
        previews = self._camera.previews(annotated=True)
        try:
            picture = next(previews, None)
        finally:
            previews.close()
        if picture is None:
            raise self._camera.state.problem or PinelError("camera_no_picture")
        return picture
