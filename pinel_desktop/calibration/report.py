"""A calibration as it is shown and stored: each parameter with its interval, source and check."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

from pinel_desktop.calibration.drive import Drive
from pinel_desktop.calibration.estimate import Estimate, unknown
from pinel_desktop.calibration.held_out import HeldOut, held_out
from pinel_desktop.calibration.robot import Calibration, calibrate
from pinel_desktop.calibration.stated_error import CalibratedWheels
from pinel_desktop.calibration.umbmark import SquareErrors, umbmark_of
from pinel_desktop.robot import RobotModel
from sim.realistic import REALISTIC

ODOMETRY = "odometry"


class ReportedParameter(NamedTuple):
    """One parameter of `RobotParameters`.

    Attributes:
        nominal: of the model, or of the preset `realistic`.
        is_known: False if the runs cannot tell it; value, low and high are then the nominal value.
        sources: what tells it: sources of truth, or `odometry`; "" in none.
    """

    name: str
    value: float
    low: float
    high: float
    nominal: float
    is_known: bool
    sources: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class CalibrationReport:
    """The result of a calibration.

    Attributes:
        model: name of the robot's model.
        runs: ids of the runs.
        values: the parameters of the simulated robot, by names of `RobotParameters`.
        held_out: predictions of runs by the other ones; `place` counts in `runs`.
        squares: UMBmark's figures, if there are squares in both directions.
        wheels: what tells the error that a prediction states (`stated_error.CalibratedWheels`); None if the runs do not
            tell the wheels.
        robot: link and address of the real robot.
    """

    model: str
    runs: tuple[str, ...]
    values: dict[str, float]
    parameters: tuple[ReportedParameter, ...]
    held_out: tuple[HeldOut, ...]
    squares: SquareErrors | None
    wheels: dict[str, Any] | None
    robot: tuple[str, str]

    def as_record(self) -> dict[str, Any]:
        """Returns plain JSON data for the store."""
        return {
            **asdict(self),
            "parameters": [one._asdict() for one in self.parameters],
            "held_out": [one._asdict() for one in self.held_out],
            "squares": self.squares and self.squares._asdict(),
        }


def report_of(
    drives: Sequence[Drive],
    model: RobotModel,
    runs: Sequence[str],
    sources: Sequence[str],
    robot: tuple[str, str],
) -> CalibrationReport:
    """Calibrates a robot.

    Args:
        drives: the runs; `runs` are their ids.
        sources: the sources of truth of the runs.
        robot: link and address.

    Raises:
        PinelError: `calibration_without_motion`; `robot_parameter_range` for an absurd result.
    """
    found = calibrate(drives, model)
    predictions = held_out(drives, found.wheels, model.track_m)
    return CalibrationReport(
        model.name,
        tuple(runs),
        found.parameters.changes,
        tuple(_parameters(found, model, sources)),
        tuple(predictions),
        umbmark_of(drives, model.track_m, predictions),
        CalibratedWheels(found.wheels, model.track_m).as_record(),
        robot,
    )


def _parameters(
    found: Calibration, model: RobotModel, sources: Sequence[str]
) -> list[ReportedParameter]:
    truth, wheels = tuple(sources), found.wheels
    noise = Estimate(
        wheels.wheel_noise, wheels.wheel_noise, wheels.wheel_noise, wheels.noise_is_known
    )
    estimates = {**found.estimates, **({"wheel_noise": noise} if wheels.noise_is_known else {})}
    nominal = {
        "track_m": (model.track_m, truth),
        "wheel_bias_left": (0.0, truth),
        "wheel_bias_right": (0.0, truth),
        "wheel_noise": (REALISTIC.wheel_noise, truth),
        "lag_s": (REALISTIC.lag_s, (ODOMETRY,)),
        "latency_s": (REALISTIC.latency_s, (ODOMETRY,)),
    }
    return [
        _reported(name, estimates.get(name, unknown(value)), value, by)
        for name, (value, by) in nominal.items()
    ]


def _reported(name: str, one: Estimate, nominal: float, by: tuple[str, ...]) -> ReportedParameter:
    sources = by if one.is_known else ()
    return ReportedParameter(name, one.value, one.low, one.high, nominal, one.is_known, sources)
