"""A fake engine controlled by the test, with the interface of EngineClient."""

from collections.abc import Callable, Sequence
from typing import Any, Literal

from pinel_desktop.engine.commands import Command, Evaluate
from pinel_desktop.errors import PinelError
from pinel_desktop.robot.record import RobotRecord
from pinel_desktop.runs.spec import RunSpec

Event = dict[str, Any]


class FakeEngine:
    def __init__(
        self, on_event: Callable[[Event], None], *, is_watched: Callable[[], bool] = lambda: True
    ) -> None:
        self.on_event = on_event
        self.state: Literal["starting", "ready", "lost"] = "starting"
        self.live_run: str | None = None
        self.told: list[Command] = []
        self.begun: dict[str, Any] = {}
        self.first: list[Command] = []

    def start(self) -> None:
        self.state = "ready"

    def run(self, run_id: str, spec: RunSpec, commands: Sequence[Command] = ()) -> None:
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        self.live_run = run_id
        self.begun = {"run": run_id, **spec.as_message()}
        self.first = list(commands)

    def contact(self, robot: RobotRecord) -> dict[str, Any]:
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        if robot.link != "bridge":
            raise PinelError("robot_not_found", topic="/cmd_vel", domain=0)
        pose = {"x_m": 1.0, "y_m": 0.0, "heading_deg": 90.0}
        return {**pose, "rate_hz": 30.0, "battery": None}

    def command(self, run_id: str, command: Command) -> Any:
        if run_id != self.live_run:
            raise PinelError("run_not_live")
        self.told.append(command)
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
