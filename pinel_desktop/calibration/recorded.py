"""From recorded runs of one real robot to its calibration."""

from collections.abc import Sequence

import numpy as np

from pinel_desktop.calibration.drive import Drive, Floats
from pinel_desktop.calibration.report import CalibrationReport, report_of
from pinel_desktop.errors import PinelError
from pinel_desktop.robot import RobotModel, simulation_config_from
from pinel_desktop.robot.robot_profile import profile_from
from pinel_desktop.runs.truth import TruePose, Truth, best_at_end, best_during_run, truths_of
from storage import SIMULATOR, RunRow, Store

# A camera sees 30 poses in a second, whose errors are not independent.
_TRUTH_EACH_TICKS = 15
_ODOMETRY = ("x_m", "y_m", "yaw_rad")
_VELOCITY = ("v_mps", "omega_radps")
_COMMAND = ("command_v_mps", "command_omega_radps")


def calibrate_runs(store: Store, rows: Sequence[RunRow]) -> CalibrationReport:
    """Calibrates the robot that drove the given runs.

    Raises:
        PinelError: `calibration_without_runs`, `calibration_of_simulator`, `calibration_run_old` for a run that lacks
            what is needed, `calibration_two_robots`; `calibration_without_motion`; `robot_parameter_range` for an
            absurd result; `run_damaged`, `unknown_robot` for an unreadable record.
        StoreError: `run_damaged`.
    """
    if not rows:
        raise PinelError("calibration_without_runs")
    robots = {_robot_of(row) for row in rows}
    if len(robots) > 1:
        raise PinelError("calibration_two_robots")
    truths = [truths_of(store.truths.of_run(row.id)) for row in rows]
    drives = [drive_of(store, row, of_run) for row, of_run in zip(rows, truths, strict=True)]
    sources = sorted({one.source for of_run in truths for one in _used(of_run)})
    link, address, _ = robots.pop()
    runs = [row.id for row in rows]
    return report_of(drives, _model_of(rows[0]), runs, sources, (link, address))


def drive_of(store: Store, row: RunRow, truths: Sequence[Truth]) -> Drive:
    """Returns a run as calibration sees it. Raises PinelError `calibration_run_old`."""
    telemetry = store.runs.telemetry(row.id)
    columns = {name: telemetry.column(name) for name in ("tick", *_ODOMETRY, *_VELOCITY, *_COMMAND)}
    usable = np.all(np.isfinite(np.array(list(columns.values()))), axis=0)
    if not usable.any():
        raise PinelError("calibration_run_old", id=row.id)
    columns = {name: values[usable] for name, values in columns.items()}
    columns["yaw_rad"] = np.unwrap(columns["yaw_rad"])
    n_ticks = int(columns["tick"][-1])
    at_start = np.zeros((1, 2))
    return Drive(
        np.vstack((np.zeros((1, 3)), _by_tick(columns, _ODOMETRY, n_ticks))),
        np.vstack((at_start, _by_tick(columns, _VELOCITY, n_ticks))),
        np.vstack((_by_tick(columns, _COMMAND, n_ticks), at_start)),
        tuple(_true_poses(truths, n_ticks)),
    )


def _by_tick(columns: dict[str, Floats], names: Sequence[str], n_ticks: int) -> Floats:
    """Returns columns at ticks 1 to n; a sample that was not recorded lies between its neighbours."""
    ticks = np.arange(1, n_ticks + 1)
    return np.column_stack([np.interp(ticks, columns["tick"], columns[name]) for name in names])


def _used(truths: Sequence[Truth]) -> list[Truth]:
    """Returns the truths that calibration uses: one along the way, and the one that knows the end best."""
    along, end = best_during_run(truths), best_at_end(_at_end(truths))
    return [one for one in (along, end) if one is not None]


def _at_end(truths: Sequence[Truth]) -> list[Truth]:
    return [one for one in truths if one.end.tick is None]


def _true_poses(truths: Sequence[Truth], n_ticks: int) -> list[TruePose]:
    """Returns the poses along the way, not more often than needed and the last one, then the pose at the end."""
    found: list[TruePose] = []
    along, end = best_during_run(truths), best_at_end(_at_end(truths))
    next_tick = _TRUTH_EACH_TICKS
    seen = [one for one in (along.during_run if along else ()) if one.tick and one.tick <= n_ticks]
    for one in seen:
        if one.tick is not None and (one.tick >= next_tick or one is seen[-1]):
            found.append(one)
            next_tick = one.tick + _TRUTH_EACH_TICKS
    return [*found, end.end] if end else found


def _model_of(row: RunRow) -> RobotModel:
    return simulation_config_from(row.parameters).robot


def _robot_of(row: RunRow) -> tuple[str, str, str]:
    """Returns what tells one robot from another: link, address, model.

    Raises PinelError `calibration_of_simulator`, `calibration_run_old`, and what reading the record raises.
    """
    if row.link == SIMULATOR:
        raise PinelError("calibration_of_simulator", id=row.id)
    record = row.parameters.get("robot")
    if not isinstance(record, dict):
        raise PinelError("calibration_run_old", id=row.id)
    return row.link, profile_from(record).address, _model_of(row).name
