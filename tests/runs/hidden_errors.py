"""A double of a real robot whose wheels report something else than what it does; its runs as they are recorded."""

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.robot import Pose2D, SimulationConfig
from pinel_desktop.robot.robot_profile import BridgeProfile
from pinel_desktop.runs.difference import Difference, difference
from pinel_desktop.runs.measured import Measured, measured_poses
from pinel_desktop.runs.prediction import Path, predict, steps_of
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.runs.truth import TAPE_SIGMA_M, TAPE_SIGMA_RAD, TruePose, Truth

Wire = dict[str, Any]
ROOM = {"width_m": 6.0, "depth_m": 6.0}
PROFILE = BridgeProfile.model_validate({"room": ROOM, "max_v_mps": 1.2, "max_omega_dps": 90.0})
TOLERANCE = (PROFILE.move_tolerance_m, PROFILE.turn_tolerance_deg)
AHEAD = {"action": "move_forward", "distance": 1, "block": "ahead"}
TURN = {"action": "turn", "angle": 90, "block": "turn"}
SIDE = [AHEAD, TURN]
SQUARE = {
    "pinel_ir": 1,
    "commands": [{"action": "repeat", "times": 4, "commands": SIDE, "block": "loop"}],
}


@dataclass
class Driven:
    """A run as it would be recorded: what the robot reported, and where it truly was."""

    spec: RunSpec
    wire: list[Wire]  # all events as the engine sends them
    events: list[Wire]  # those without telemetry
    odometry: Path
    true: Path

    def beside(self, measured: Measured, *, is_whole: bool = True) -> Difference:
        return difference(
            predict(self.spec, self.events),
            measured,
            steps_of(self.events),
            is_whole=is_whole,
            tolerance=TOLERANCE,
        )

    def by_odometry(self) -> Difference:
        return self.beside(measured_poses(self.odometry[1:], []))

    def by_camera(self, noise_m: float = 0.01, noise_deg: float = 1.0, seed: int = 1) -> Difference:
        draw = np.random.default_rng(seed)
        sigma = np.array([noise_m, noise_m, math.radians(noise_deg)])
        poses = self.true + draw.normal(size=self.true.shape) * sigma
        frames = range(0, len(poses), 2)  # the camera's rate
        poses_of_camera = [
            TruePose(tick, Pose2D(*map(float, poses[tick])), *sigma[1:]) for tick in frames
        ]
        return self.beside(
            measured_poses(self.odometry[1:], [Truth("camera", tuple(poses_of_camera))])
        )

    @property
    def tape(self) -> TruePose:
        """What a person measures after the run."""
        return TruePose(None, Pose2D(*map(float, self.true[-1])), TAPE_SIGMA_M, TAPE_SIGMA_RAD)

    def by_tape(self, sigma_rad: float = TAPE_SIGMA_RAD) -> Difference:
        end = self.tape._replace(sigma_rad=sigma_rad)
        return self.beside(measured_poses(self.odometry[1:], [Truth("tape", (end,))]))


def drive(
    document: Wire = SQUARE,
    *,
    turns: float = 1.0,
    rolls: float = 1.0,
    pushed: tuple[int, float] | None = None,
    answers: tuple[str, ...] = (),
    seed: int = 0,
    run: str = "run",
) -> Driven:
    """Drives a double.

    Args:
        answers: to its questions.
        turns, rolls: its true turn and distance, as parts of what its wheels report.
        pushed: the step soon after whose start somebody turns it, and by how many degrees.
    """
    spec = RunSpec(document, PROFILE.room.as_world(), link="bridge", robot=PROFILE, seed=seed)
    stamp, wire, poses = EventSequencer(run), [], [(0.0, 0.0, 0.0)]

    def observe(tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            event = replace(event, true_x_m=None, true_y_m=None, true_yaw_rad=None)
            poses.append((event.x_m, event.y_m, event.yaw_rad))
        wire.append(stamp.wire(tick, event))

    late = SimulationConfig(preset="realistic", feedback="odometry")
    start(replace(spec, link="sim", setting=late, inputs=ScriptedInputs(answers=answers)), observe)
    odometry = np.array(poses)
    events = [event for event in wire if event["type"] != Telemetry.type]
    steps = steps_of(events)
    push = None if pushed is None else (steps[pushed[0]].start + 10, math.radians(pushed[1]))
    return Driven(spec, wire, events, odometry, _true_path(odometry, turns, rolls, push))


def _true_path(odometry: Path, turns: float, rolls: float, push: tuple[int, float] | None) -> Path:
    yaws = np.unwrap(odometry[:, 2])
    true = [np.zeros(3)]
    for tick in range(1, len(odometry)):
        dx, dy = odometry[tick, :2] - odometry[tick - 1, :2]
        middle = (yaws[tick] + yaws[tick - 1]) / 2
        rolled = rolls * (math.cos(middle) * dx + math.sin(middle) * dy)
        turned = turns * (yaws[tick] - yaws[tick - 1])
        if push is not None and tick == push[0]:
            turned += push[1]
        x, y, yaw = true[-1]
        ahead = yaw + turned / 2
        true.append(
            np.array([x + rolled * math.cos(ahead), y + rolled * math.sin(ahead), yaw + turned])
        )
    return np.array(true)
