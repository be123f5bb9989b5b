"""Calibrated robots in runs: as the simulated robot, and as the one that predicts the run of a real robot."""

from contextlib import suppress
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import SimulationConfig, robot_parameters_from
from storage import CalibratedRobotRow, Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.robot.robot_profile import RobotProfile

PREDICTOR = "predicted_by"  # among a run's parameters


def calibrated_setting(store: Store, robot_id: str) -> SimulationConfig:
    """Returns the simulation configuration of a calibrated robot: realistic, by odometry, with its parameters.

    Raises:
        PinelError: `calibrated_robot_deleted`; `unknown_robot`, `unknown_robot_parameter`, `robot_parameter_range` for
            one of a newer release.
        StoreError: `calibrated_robot_not_found`.
    """
    return _setting_of(store.calibrated_robots.get(robot_id))


def predictor_of(
    store: Store, chosen: str | None, profile: "RobotProfile"
) -> dict[str, Any] | None:
    """Returns the record of the calibrated robot that predicts a run on a real robot.

    It is the chosen one, else the newest that was calibrated from this real robot, and in full, so that a prediction
    stays as it is when the robot is calibrated again or deleted. None for the ideal robot, also if the chosen one
    cannot be used: the run on the real robot does not need it.
    """
    with suppress(PinelError, StoreError):
        row = store.calibrated_robots.get(chosen) if chosen else _belonging_to(store, profile)
        if row is not None:
            wheels = row.report.get("wheels")
            return {"title": row.title, **_setting_of(row).as_parameters(), "wheels": wheels}
    return None


def _belonging_to(store: Store, profile: "RobotProfile") -> CalibratedRobotRow | None:
    robot = [profile.link, profile.address]
    return next(
        (
            row
            for row in reversed(store.calibrated_robots.all())
            if row.report.get("robot") == robot
        ),
        None,
    )


def _setting_of(row: CalibratedRobotRow) -> SimulationConfig:
    if row.deleted_at is not None:
        raise PinelError("calibrated_robot_deleted", title=row.title)
    parameters = robot_parameters_from(row.parameters)
    setting = SimulationConfig(row.model, "realistic", "odometry", parameters)
    _ = setting.robot  # raises unknown_robot before anything is stored
    return setting
