"""Answers a request for the prediction of a real robot's run."""

from collections.abc import Mapping
from dataclasses import asdict, replace

import numpy as np

from pinel_desktop.calibration.stated_error import CalibratedWheels, end_radius_m
from pinel_desktop.errors import PinelError
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.judge.messages import PredictedRun, PredictionRequest
from pinel_desktop.robot import simulation_config_from
from pinel_desktop.runs.difference import difference
from pinel_desktop.runs.measured import measured_poses
from pinel_desktop.runs.prediction import Path, predict, steps_of
from pinel_desktop.runs.spec import spec_from
from pinel_desktop.runs.truth import read_truth

_POSES = ("x_m", "y_m", "yaw_rad")
_EVERY_TICKS = 3


def predicted_run(request: PredictionRequest) -> PredictedRun:
    """Predicts a run and compares it with its prediction.

    Raises:
        PinelError: `run_damaged` for a spec without a robot or an unreadable predictor, and any error of `predict`.
    """
    spec, predictor = spec_from(request.spec, ScriptedInputs()), request.predictor
    profile = spec.robot
    if profile is None:
        raise PinelError("run_damaged", part="parameters")
    if predictor is not None:
        spec = replace(spec, setting=simulation_config_from(predictor))
    prediction = predict(spec, request.events)
    rows = np.column_stack([request.columns[name] for name in _POSES])
    found = (read_truth(source, poses) for source, poses in request.truths)
    truths = [truth for truth in found if truth is not None]
    beside = difference(
        prediction,
        measured_poses(rows, truths),
        steps_of(request.events),
        is_whole=request.is_whole,
        tolerance=(profile.move_tolerance_m, profile.turn_tolerance_deg),
    )
    return PredictedRun(
        None if predictor is None else str(predictor.get("title", "")),
        _within_m(prediction.odometry, (predictor or {}).get("wheels")),
        _thinned(prediction.path),
        [asdict(step) for step in prediction.steps],
        prediction.awaits_input,
        prediction.is_cut,
        prediction.reads_sensors,
        prediction.knows_room,
        asdict(beside),
    )


def _within_m(odometry: Path, wheels: object) -> float | None:
    robot = CalibratedWheels.from_record(wheels) if isinstance(wheels, Mapping) else None
    return None if robot is None else end_radius_m(odometry, robot)


def _thinned(path: Path) -> list[tuple[float, ...]]:
    last = len(path) - 1
    ticks = [*range(0, last, _EVERY_TICKS), last]
    return [(tick, *(round(float(value), 4) for value in path[tick])) for tick in ticks]
