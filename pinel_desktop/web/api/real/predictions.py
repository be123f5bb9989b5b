"""Predictions of runs on real robots."""

from flask import Response

from pinel_desktop.web.api import TEACHER, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.real.predictions import RunPrediction, UnusualRun, UnusualRuns
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher

api = Resource("predictions", "Predictions of runs on real robots.", __name__)


@api.get(
    "/runs/<id>/prediction",
    responses=responses(
        RunPrediction,
        "run_not_found",
        "prediction_simulated",
        "prediction_no_robot",
        "run_not_repeatable",
        "run_newer",
        "run_damaged",
        "judge_lost",
    ),
)
def get_prediction(path: IdPath) -> Response:
    """What the calibrated robot of the run, or else the ideal one, does with its spec, and the run beside it.

    During the run the prediction ends at an input that nobody has given yet.
    """
    parts = services()
    if parts.engine.live_run == path.id:
        parts.flush_recording()
    return json_response(RunPrediction.of(parts.predictions.of_run(path.id)))


@api.get("/unusual-runs", responses=responses(UnusualRuns, *TEACHER))
def list_unusual_runs() -> Response:
    """Runs among the newest ones that are out of the ordinary for their real robot. For the teacher.

    Empty while a run is live: the PC then works for the robot.
    """
    require_teacher()
    parts = services()
    if parts.engine.live_run is not None:
        return json_response(UnusualRuns(runs=[]))
    found = parts.predictions.unusual_runs()
    return json_response(
        UnusualRuns(
            runs=[UnusualRun.of(outlier, run=run, source=source) for run, source, outlier in found]
        )
    )
