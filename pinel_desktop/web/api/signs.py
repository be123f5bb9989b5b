"""Signs: the signs that the camera recognises, and the signs that a class teaches."""

from flask import Response

from pinel_desktop.web.api import WRITES, Resource, responses
from pinel_desktop.web.models import Empty, IdPath
from pinel_desktop.web.models.signs import (
    ClassroomOfCamera,
    Sign,
    SignList,
    SignName,
    SignPath,
)
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services

api = Resource("signs", "Signs that the camera knows, and that classes teach it.", __name__)
_RECORDING = (
    "classroom_not_found",
    "name_empty",
    "sign_name_wrong",
    "sign_taught_enough",
    "signs_too_many",
    *WRITES,
)


@api.get("/signs", responses=responses(SignList))
def list_signs() -> Response:
    """The letters that the camera recognises without teaching."""
    return _signs(None)


@api.get("/classrooms/<id>/signs", responses=responses(SignList, "classroom_not_found"))
def list_signs_of_classroom(path: IdPath) -> Response:
    """The letters, and the signs that the class taught."""
    return _signs(path.id)


@api.put("/camera/classroom", responses=responses(SignList, "classroom_not_found"))
def choose_classroom_of_camera(body: ClassroomOfCamera) -> Response:
    """Sets the class whose taught signs the camera recognises: the class of the opened or running program."""
    services().signs.use(body.classroom_id)
    return _signs(body.classroom_id)


@api.post("/classrooms/<id>/signs/<sign>/samples", responses=responses(SignName, *_RECORDING))
def record_sign(path: SignPath) -> Response:
    """Starts to record hands as a sign of the class. `sign_recording` events report each detected hand."""
    return json_response(SignName(name=services().signs.record(path.id, path.sign)))


@api.post("/classrooms/<id>/signs/<sign>/movements", responses=responses(SignName, *_RECORDING))
def record_moving_sign(path: SignPath) -> Response:
    """Starts to record movements as a sign of the class. `sign_recording` events report each movement."""
    name = services().signs.record(path.id, path.sign, is_moving=True)
    return json_response(SignName(name=name))


@api.delete("/signs/recording", responses=responses(Empty))
def stop_recording_sign() -> Response:
    """Stops the recording of a sign; does nothing without one."""
    services().signs.stop()
    return json_response(Empty())


@api.delete(
    "/classrooms/<id>/signs/<sign>",
    responses=responses(SignList, "classroom_not_found", "taught_sign_not_found", *WRITES),
)
def delete_sign(path: SignPath) -> Response:
    """Deletes all samples of a sign that the class taught, also from the backups.

    A letter keeps its shipped samples.
    """
    services().signs.forget(path.id, path.sign)
    return _signs(path.id)


def _signs(classroom_id: str | None) -> Response:
    return json_response(
        SignList(signs=[Sign.of(one) for one in services().signs.signs(classroom_id)])
    )
