"""Calibrated robots in simulated runs: a row of the store as a simulation configuration."""

from pinel_desktop.errors import PinelError
from pinel_desktop.robot import SimulationConfig, robot_parameters_from
from storage import Store


def calibrated_setting(store: Store, robot_id: str) -> SimulationConfig:
    """Returns the simulation configuration of a calibrated robot: realistic, by odometry, with its parameters.

    Raises:
        PinelError: `calibrated_robot_deleted`; `unknown_robot`, `unknown_robot_parameter`, `robot_parameter_range` for
            one of a newer release.
        StoreError: `calibrated_robot_not_found`.
    """
    row = store.calibrated_robots.get(robot_id)
    if row.deleted_at is not None:
        raise PinelError("calibrated_robot_deleted", title=row.title)
    parameters = robot_parameters_from(row.parameters)
    setting = SimulationConfig(row.model, "realistic", "odometry", parameters)
    _ = setting.robot  # raises unknown_robot before anything is stored
    return setting
