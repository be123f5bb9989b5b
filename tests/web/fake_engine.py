"""An engine that does what a test says, with the interface of EngineClient."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal

from pinel_desktop.errors import PinelError

Event = dict[str, Any]


class FakeEngine:
    def __init__(self, on_event: Callable[[Event], None]) -> None:
        self.on_event = on_event
        self.state: Literal["starting", "ready", "lost"] = "starting"
        self.live_run: str | None = None
        self.told: list[tuple[str, ...]] = []
        self.begun: dict[str, Any] = {}

    def start(self) -> None:
        self.state = "ready"

    def run(
        self,
        run_id: str,
        document: dict[str, Any],
        *,
        world: str | dict[str, Any],
        seed: int = 0,
        link: str = "sim",
        setting: Mapping[str, Any] | None = None,
        debugging: Mapping[str, Any] | None = None,
    ) -> None:
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        self.live_run = run_id
        self.begun = {
            "run": run_id,
            "document": document,
            "world": world,
            "setting": dict(setting or {}),
            "seed": seed,
            "link": link,
            **(debugging or {}),
        }

    def pause(self, run_id: str) -> None:
        self._tell("pause", run_id)

    def resume(self, run_id: str) -> None:
        self._tell("resume", run_id)

    def stop(self, run_id: str) -> None:
        self._tell("stop", run_id)

    def step(self, run_id: str, mode: str) -> None:
        self._tell("step", run_id, mode)

    def set_breakpoints(self, run_id: str, blocks: Sequence[str]) -> None:
        self._tell("breakpoints", run_id, *blocks)

    def set_speed(self, run_id: str, factor: float) -> None:
        self._tell("speed", run_id, str(factor))

    def look(self, run_id: str, sensors: Sequence[str]) -> None:
        self._tell("look", run_id, *sensors)

    def evaluate(self, run_id: str, expression: Any) -> Any:
        self._tell("evaluate", run_id, str(expression))
        if expression == {"call": "f"}:
            raise PinelError("peek_not_possible")
        return 42

    def answer_capture(self, run_id: str, result: str) -> None:
        self._tell("answer_capture", run_id, result)

    def answer_question(self, run_id: str, value: str) -> None:
        self._tell("answer_question", run_id, value)

    def close(self) -> None:
        self.live_run = None

    def send(self, event: Event) -> None:
        """An event of the live run arrives."""
        if event["type"] == "run_ended":
            self.live_run = None
        self.on_event(event)

    def _tell(self, what: str, run_id: str, *values: str) -> None:
        if run_id != self.live_run:
            raise PinelError("run_not_live")
        self.told.append((what, run_id, *values))
