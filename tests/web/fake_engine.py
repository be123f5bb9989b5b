"""An engine controlled by the test, without a process."""

import threading
from collections.abc import Callable, Sequence
from typing import Any

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.engine.commands import Command, Evaluate
from pinel_desktop.errors import PinelError
from pinel_desktop.processes.supervisor import ProcessState
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.fixed_inputs import FixedInputs
from pinel_desktop.runs.spec import RunSpec

Event = dict[str, Any]


class FakeEngine(EngineClient):
    state: ProcessState = "starting"
    live_run: str | None = None

    def __init__(
        self,
        on_event: Callable[[Event], None],
        *,
        on_robot: Callable[[Event], None] = lambda state: None,
        on_localised: Callable[[Event], None] = lambda message: None,
        is_watched: Callable[[], bool] = lambda: True,
    ) -> None:
        self.on_event, self.on_robot, self.on_localised = on_event, on_robot, on_localised
        self.started = threading.Event()
        self.of_robots: list[tuple[Any, ...]] = []
        self.commands: list[Command] = []
        self.start_spec: dict[str, Any] = {}
        self.first: list[Command] = []
        self.inputs: FixedInputs | None = None

    def start(self) -> None:
        self.state = "ready"
        self.started.set()

    def run(
        self,
        run_id: str,
        spec: RunSpec,
        commands: Sequence[Command] = (),
        inputs: FixedInputs | None = None,
    ) -> None:
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        self.live_run = run_id
        self.start_spec = {"run": run_id, **spec.as_message()}
        self.first, self.inputs = list(commands), inputs

    def contact(self, robot: RobotProfile) -> dict[str, Any]:
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        if robot.link != "bridge":
            raise PinelError("robot_not_found", topic="/cmd_vel", domain=0)
        pose = {"x_m": 1.0, "y_m": 0.0, "heading_deg": 90.0}
        return {**pose, "rate_hz": 30.0, "battery": None}

    def find(self, robot: RobotProfile) -> list[dict[str, Any]]:
        names = {"command_topic": "cmd_vel", "odometry_topic": "odom"}
        return [{"namespace": "r1", **names, "holder": "LAB-03"}]

    def watch(self, robot: RobotProfile) -> None:
        self.of_robots.append(("watch", robot.link))

    def jog(self, robot: RobotProfile, drive: float, turn: float, sent_s: float) -> None:
        if self.live_run is not None:
            raise PinelError("run_in_progress")
        self.of_robots.append(("jog", robot.link, drive, turn, sent_s))

    def halt(self, robot: RobotProfile) -> None:
        self.of_robots.append(("halt", robot.link))

    def set_start_here(self, robot: RobotProfile) -> None:
        self.of_robots.append(("at_start", robot.link))

    def command(self, run_id: str, command: Command) -> Any:
        if run_id != self.live_run:
            raise PinelError("run_not_live")
        self.commands.append(command)
        if not isinstance(command, Evaluate):
            return None
        if command.expression == {"call": "f"}:
            raise PinelError("peek_not_possible")
        return 42

    def close(self) -> None:
        self.live_run = None

    def send(self, event: Event) -> None:
        """Delivers an event of the live run."""
        if event["type"] == "run_ended":
            self.live_run = None
        self.on_event(event)
