"""Where a real robot truly was in its runs, by source of truth."""

import math
from typing import TYPE_CHECKING

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.robot import Pose2D
from pinel_desktop.runs.truth import Truth as KnownTruth
from pinel_desktop.runs.truth import check_in_room, read_truth, truths_of
from pinel_desktop.web.api import WRITES, Resource, responses
from pinel_desktop.web.api.runs import world_of
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.real.truths import (
    BelievedPose,
    TruePose,
    Truth,
    TruthList,
    TruthPath,
    TruthPoses,
)
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from storage import SIMULATOR, RunRow, TruePoseRow, TruthRow

if TYPE_CHECKING:  # numpy takes a seventh of the app's start
    from storage.runs.telemetry import Telemetry

api = Resource("truths", "Where real robots truly were in their runs.", __name__)


@api.get("/runs/<id>/truths", responses=responses(TruthList, "run_not_found"))
def list_truths(path: IdPath) -> Response:
    """What each source of truth says about a run."""
    return _truths(services().store.runs.get(path.id).id)


@api.put(
    "/runs/<id>/truths/<source>",
    responses=responses(
        TruthList,
        "run_not_found",
        "truth_of_simulator",
        "truth_range",
        "truth_order",
        "truth_too_many",
        "truth_outside_room",
        *WRITES,
    ),
)
def put_truth(path: TruthPath, body: TruthPoses) -> Response:
    """Replaces what a source says about a run on a real robot; with a tape the pose must be in the robot's room."""
    store = services().store
    row = store.runs.get(path.id)
    if row.link == SIMULATOR:
        raise PinelError("truth_of_simulator")
    truth = read_truth(path.source, [_row(pose) for pose in body.poses])
    if truth and path.source == "tape":
        _check_in_room(truth.end.pose, row)
    store.truths.record(row.id, path.source, truth.as_rows() if truth else [])
    return _truths(row.id)


def _check_in_room(pose: Pose2D, row: RunRow) -> None:
    world = world_of(row)
    start = Pose2D(world.start.x_m, world.start.y_m, math.radians(world.start.heading_deg))
    check_in_room(pose, start, *world.size_m)


def _row(pose: TruePose) -> TruePoseRow:
    return pose.tick, pose.x_m, pose.y_m, pose.heading_rad, pose.sigma_m, pose.sigma_rad


def _truths(run_id: str) -> Response:
    rows = services().store.truths.of_run(run_id)
    telemetry = services().store.runs.telemetry(run_id)
    truths = [_truth(row, truth) for row, truth in zip(rows, truths_of(rows), strict=True)]
    return json_response(
        TruthList(truths=truths, believed=_believed(telemetry), run_s=len(telemetry.rows) / TICK_HZ)
    )


def _truth(row: TruthRow, truth: KnownTruth) -> Truth:
    names = TruePose.model_fields
    poses = [dict(zip(names, pose, strict=True)) for pose in row.poses]
    return Truth.of(row, poses=poses, covered_s=truth.covered_ticks / TICK_HZ)


def _believed(telemetry: "Telemetry") -> BelievedPose | None:
    if not len(telemetry.rows):
        return None
    x, y, heading = (float(telemetry.column(name)[-1]) for name in ("x_m", "y_m", "yaw_rad"))
    return BelievedPose(x_m=x, y_m=y, heading_rad=heading)
