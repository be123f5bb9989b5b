"""Calibration: what recorded runs tell about a real robot, and the robots of the simulator that it makes."""

from typing import TYPE_CHECKING

from flask import Response

from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import Empty, IdPath
from pinel_desktop.web.models.robots import (
    CalibratedRobot,
    CalibratedRobotList,
    Calibration,
    NewCalibratedRobot,
    RealRun,
    RealRunList,
    RunsOfRobot,
)
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher

if TYPE_CHECKING:
    from pinel_desktop.calibration.report import CalibrationReport

api = Resource("calibration", "Robots of the simulator with the errors of a real one.", __name__)

_MAX_RUNS = 40
_REFUSALS = (
    "run_not_found",
    "run_damaged",
    "calibration_without_runs",
    "calibration_of_simulator",
    "calibration_run_old",
    "calibration_two_robots",
    "calibration_without_motion",
    "robot_parameter_range",
)


@api.get("/calibrated-robots", responses=responses(CalibratedRobotList))
def list_calibrated_robots() -> Response:
    """The calibrated robots that were made on this PC or merged from files."""
    rows = services().store.calibrated_robots.all()
    return json_response(CalibratedRobotList(robots=[CalibratedRobot.of(row) for row in rows]))


@api.get("/real-runs", responses=responses(RealRunList, *TEACHER))
def list_real_runs() -> Response:
    """The newest runs on real robots that have ended. For the teacher."""
    from pinel_desktop.calibration.pattern import shape_of  # noqa: PLC0415 - heavy, by its package

    require_teacher()
    store = services().store
    names = {group.id: group.name for group in store.groups.all()}
    found = [
        RealRun.of(
            row,
            group_name=names.get(row.group_id or ""),
            sources=[truth.source for truth in store.truths.of_run(row.id)],
            shape=shape_of(row.path) if row.state == "finished" else None,
        )
        for row in store.runs.newest_real(_MAX_RUNS)
    ]
    return json_response(RealRunList(runs=found))


@api.post("/calibrations", responses=responses(Calibration, *TEACHER, *_REFUSALS))
def calibrate(body: RunsOfRobot) -> Response:
    """What runs tell about a real robot. Stores nothing. For the teacher."""
    require_teacher()
    record = _report(body).as_record()
    shown = {name: record[name] for name in Calibration.model_fields}
    return json_response(Calibration.model_validate(shown))


@api.post(
    "/calibrated-robots",
    responses=responses(
        CalibratedRobot,
        *TEACHER,
        *_REFUSALS,
        "name_empty",
        "name_too_long",
        "calibrated_robots_too_many",
        *WRITES,
    ),
)
def create_calibrated_robot(body: NewCalibratedRobot) -> Response:
    """Stores what runs tell about a real robot as a robot that groups choose in the simulator. For the teacher."""
    require_teacher()
    report = _report(body)
    row = services().store.calibrated_robots.create(
        body.title, report.model, report.values, report.as_record()
    )
    return json_response(CalibratedRobot.of(row))


@api.delete(
    "/calibrated-robots/<id>",
    responses=responses(Empty, *TEACHER, "calibrated_robot_not_found", *WRITES),
)
def delete_calibrated_robot(path: IdPath) -> Response:
    """Removes a calibrated robot from the lists; its runs stay as they are. For the teacher."""
    require_teacher()
    services().store.calibrated_robots.delete(path.id)
    return json_response(Empty())


@api.post(
    "/calibrated-robots/<id>/take-back",
    responses=responses(Empty, *TEACHER, "calibrated_robot_not_found", *WRITES),
)
def restore_calibrated_robot(path: IdPath) -> Response:
    """Restores a deleted calibrated robot to the lists. For the teacher."""
    require_teacher()
    services().store.calibrated_robots.undelete(path.id)
    return json_response(Empty())


def _report(body: RunsOfRobot) -> "CalibrationReport":
    from pinel_desktop.calibration.recorded import calibrate_runs  # noqa: PLC0415 - heavy

    store = services().store
    return calibrate_runs(store, [store.runs.get(run) for run in dict.fromkeys(body.runs)])
