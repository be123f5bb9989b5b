"""The camera: its state, its choice, and its picture. Events report what it detects."""

from collections.abc import Iterator

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import explain
from pinel_desktop.settings import CAMERA
from pinel_desktop.web.api import TEACHER, Resource, responses
from pinel_desktop.web.api.exchange import UploadedFile, uploaded
from pinel_desktop.web.models.camera import (
    CameraChoice,
    CameraProblem,
    CameraStatus,
    DetectorPath,
    NameOfDetectorFile,
    RecognizerChoice,
    Recognizers,
)
from pinel_desktop.web.responses import json_response, json_safe
from pinel_desktop.web.services import Services, services
from pinel_desktop.web.teaching import require_teacher

api = Resource("camera", "The camera that sees signs.", __name__)

_BOUNDARY = b"frame"
_UNUSABLE = ("recognizer_of_command", "recognizer_slow", "detector_missing", "detector_unreadable")
_PICTURES = {
    "description": "JPEG pictures as they come, each in place of the one before.",
    "content": {"multipart/x-mixed-replace": {"schema": {"type": "string", "format": "binary"}}},
}


@api.get("/camera", responses=responses(CameraStatus))
def get_camera() -> Response:
    """State of the camera."""
    return _state(services())


@api.put("/camera", responses=responses(CameraStatus))
def put_camera(body: CameraChoice) -> Response:
    """Chooses the camera."""
    parts = services()
    parts.settings.choose(CAMERA, body.source)
    parts.camera.set_source(body.source)
    return _state(parts)


@api.post("/camera/wake", responses=responses(CameraStatus))
def start_camera() -> Response:
    """Starts the recognition of signs; the camera itself stays off until a capture or a preview."""
    parts = services()
    parts.camera.start()
    return _state(parts)


@api.get("/camera/preview", responses=responses(_PICTURES))
def preview_camera() -> Response:
    """The mirrored picture of the camera, which is on while a client reads the stream."""
    pictures = _parts(services().camera.previews())
    mimetype = f"multipart/x-mixed-replace; boundary={_BOUNDARY.decode()}"
    return Response(pictures, mimetype=mimetype, headers={"Cache-Control": "no-store"})


@api.get("/camera/recognizers", responses=responses(Recognizers, *TEACHER))
def list_recognizers() -> Response:
    """What reads the signs, and which detectors this PC has. For the teacher."""
    require_teacher()
    services().detectors.wait_until_known()
    return _recognizers()


@api.put("/camera/recognizers", responses=responses(Recognizers, *TEACHER, *_UNUSABLE))
def choose_recognizer(body: RecognizerChoice) -> Response:
    """Chooses what reads the signs; answers when it is loaded. For the teacher."""
    require_teacher()
    services().detectors.choose(body.name)
    return _recognizers()


@api.post("/camera/recognizers", responses=responses(Recognizers, *TEACHER, *_UNUSABLE))
def add_detector(query: NameOfDetectorFile, raw: UploadedFile) -> Response:
    """Stores a detector on this PC and chooses it. The body is its ONNX file. For the teacher."""
    require_teacher()
    with uploaded(raw, query.name) as path:
        services().detectors.add(path, query.name)
    return _recognizers()


@api.delete(
    "/camera/recognizers/<name>", responses=responses(Recognizers, *TEACHER, "detector_missing")
)
def remove_detector(path: DetectorPath) -> Response:
    """Deletes a detector from this PC. For the teacher."""
    require_teacher()
    services().detectors.remove(path.name)
    return _recognizers()


def _recognizers() -> Response:
    parts = services()
    detectors, state = parts.detectors, parts.camera.recognizer
    problem = _explained(state.problem, parts.settings.language) if state.problem else None
    return json_response(
        Recognizers(
            chosen=detectors.chosen,
            in_use=detectors.in_use,
            of_command=detectors.command,
            detectors=detectors.names(),
            signs=list(state.signs or ()),
            problem=problem,
        )
    )


def _parts(pictures: Iterator[bytes]) -> Iterator[bytes]:
    for picture in pictures:
        yield b"--" + _BOUNDARY + b"\r\nContent-Type: image/jpeg\r\n\r\n" + picture + b"\r\n"


def _state(parts: Services) -> Response:
    state = parts.camera.state
    problem = _explained(state.problem, parts.settings.language) if state.problem else None
    return json_response(
        CameraStatus(state=state.mode, source=parts.camera.source, problem=problem)
    )


def _explained(problem: PinelError, language: str) -> CameraProblem:
    text, params = explain(problem, language), json_safe(problem.params)
    return CameraProblem(code=problem.code, params=params, message=text.message, remedy=text.remedy)
