"""A simulated robot with hidden errors that drives by its odometry, and true poses by a tape or a camera."""

import math
import random
from collections.abc import Sequence

import numpy as np

from pinel_desktop.calibration import Drive
from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.program.sources import read_source
from pinel_desktop.robot import Pose2D, RobotParameters, SimulationConfig
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.runs.truth import TruePose

# a line, and squares in both directions: together they tell every parameter, even by a tape
LINE = "robot.move_forward(1.8)\n"
SQUARE_LEFT = "for i in range(4):\n    robot.move_forward(1.2)\n    robot.turn(90)\n"
SQUARE_RIGHT = SQUARE_LEFT.replace("90", "-90")
PATTERN = (LINE, SQUARE_LEFT, SQUARE_RIGHT)
# UMBmark, with the fewest runs that can be checked by one another
OFFERED = (LINE, *(SQUARE_LEFT, SQUARE_RIGHT) * 3)
CAMERA_EACH_TICKS = 15
TAPE_M, TAPE_RAD = 0.01, math.radians(2.0)
CAMERA_M, CAMERA_RAD = 0.01, math.radians(1.0)


def hidden_errors(dice: random.Random) -> RobotParameters:
    """Returns the errors of a robot in use."""
    return RobotParameters(
        track_m=0.33 * (1.0 + dice.uniform(-0.04, 0.04)),
        wheel_bias_left=dice.uniform(-0.02, 0.02),
        wheel_bias_right=dice.uniform(-0.02, 0.02),
        wheel_bias_sd=0.0,
        wheel_noise=dice.uniform(0.01, 0.03),
        lag_s=dice.uniform(0.03, 0.12),
        latency_s=dice.uniform(0.02, 0.1),
    )


def rows_of(program: str, parameters: RobotParameters, seed: int) -> list[Telemetry]:
    """Drives a program in the simulator, by odometry; returns its telemetry."""
    rows: list[Telemetry] = []

    def observe(tick: int, event: Event) -> None:
        if isinstance(event, Telemetry):
            rows.append(event)

    setting = SimulationConfig(preset="realistic", feedback="odometry", parameters=parameters)
    read = read_source(program.encode(), "program.py").program
    start(RunSpec({}, "empty_room", setting=setting, seed=seed, program=read), observe)
    return rows


def driven(
    program: str, parameters: RobotParameters, seed: int, *, by: str = "camera", bad: float = 1.0
) -> Drive:
    """Returns a drive whose true poses are measured `by` a camera, a tape (only at the end) or not at all ("").

    `bad` multiplies the errors of the measurements.
    """
    rows = rows_of(program, parameters, seed)
    dice = random.Random(seed)
    return Drive(
        np.array([(0.0, 0.0, 0.0), *((one.x_m, one.y_m, one.yaw_rad) for one in rows)]),
        np.array([(0.0, 0.0), *((one.v_mps, one.omega_radps) for one in rows)]),
        np.array([*((one.command_v_mps, one.command_omega_radps) for one in rows), (0.0, 0.0)]),
        tuple(_measured(rows, dice, by, bad)),
    )


def _measured(
    rows: Sequence[Telemetry], dice: random.Random, by: str, bad: float
) -> Sequence[TruePose]:
    if not by:
        return []
    sd_m, sd_rad = (TAPE_M, TAPE_RAD) if by == "tape" else (CAMERA_M, CAMERA_RAD)
    ticks = sorted({*range(CAMERA_EACH_TICKS, len(rows), CAMERA_EACH_TICKS), len(rows)})
    found = []
    for tick in [len(rows)] if by == "tape" else ticks:
        row = rows[tick - 1]
        assert row.true_x_m is not None
        assert row.true_y_m is not None
        assert row.true_yaw_rad is not None
        found.append(
            TruePose(
                None if by == "tape" else tick,
                Pose2D(
                    row.true_x_m + bad * dice.gauss(0.0, sd_m),
                    row.true_y_m + bad * dice.gauss(0.0, sd_m),
                    row.true_yaw_rad + bad * dice.gauss(0.0, sd_rad),
                ),
                sd_m,
                sd_rad,
            )
        )
    return found
