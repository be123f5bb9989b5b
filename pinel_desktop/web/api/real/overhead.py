"""The camera above the floor, which sees where a real robot is: its sheets, its measures, its trial."""

from flask import Response

from pinel_desktop.camera.overhead.markers import OverheadSetup, checked_setup
from pinel_desktop.camera.overhead.sheets import sheets_page
from pinel_desktop.camera.overhead.wording import wording
from pinel_desktop.messages import describe
from pinel_desktop.web.api import TEACHER, Resource, responses
from pinel_desktop.web.models import Empty
from pinel_desktop.web.models.real.overhead import (
    OverheadCamera,
    OverheadMeasures,
    OverheadSheets,
    OverheadSighting,
)
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher

api = Resource("overhead", "The camera above the floor of a real robot.", __name__)


@api.get("/overhead", responses=responses(OverheadCamera, *TEACHER))
def get_overhead() -> Response:
    """Whether this PC has a camera above the floor, and what was measured. For the teacher."""
    require_teacher()
    return _camera()


@api.put("/overhead", responses=responses(OverheadCamera, *TEACHER, "overhead_range"))
def put_overhead(body: OverheadMeasures) -> Response:
    """Sets the camera above the floor up: each run on a real robot records where it sees the robot. For the teacher."""
    require_teacher()
    services().floor_camera.set_up(checked_setup(body.model_dump()))
    return _camera()


@api.delete("/overhead", responses=responses(OverheadCamera, *TEACHER))
def delete_overhead() -> Response:
    """Records no more poses with a camera. For the teacher."""
    require_teacher()
    services().floor_camera.set_up(None)
    services().floor_camera.end_trial()
    return _camera()


@api.get("/overhead/sheets", responses=responses(OverheadSheets, *TEACHER))
def get_overhead_sheets() -> Response:
    """The sheets with the markers, in the chosen language. For the teacher."""
    require_teacher()
    return json_response(OverheadSheets(page=sheets_page(services().settings.language)))


@api.post("/overhead/trial", responses=responses(OverheadSighting, *TEACHER, "overhead_not_set_up"))
def try_overhead() -> Response:
    """What the camera sees now. It is on for some seconds after each request. For the teacher."""
    require_teacher()
    parts = services()
    seen = parts.floor_camera.try_out() or {}
    pose, problem, missing = seen.get("pose"), seen.get("problem"), seen.get("missing", ())
    found = wording(pose, problem, missing)
    text = describe(*found, parts.settings.language) if found else None
    return json_response(
        OverheadSighting(
            code=found[0] if found else None,
            params=found[1] if found else {},
            message=text.message if text else "",
            remedy=text.remedy if text else "",
            markers=list(seen.get("markers", ())),
        )
    )


@api.delete("/overhead/trial", responses=responses(Empty, *TEACHER))
def end_overhead_trial() -> Response:
    """Ends the trial. For the teacher."""
    require_teacher()
    services().floor_camera.end_trial()
    return json_response(Empty())


def _camera() -> Response:
    setup = services().floor_camera.setup
    measures = (setup or OverheadSetup()).model_dump()
    return json_response(OverheadCamera(is_on=setup is not None, **measures))
