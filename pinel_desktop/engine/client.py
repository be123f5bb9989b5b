"""The app's side of the engine: sends messages to its process, hands on its events."""

import math
import threading
import time
from collections.abc import Callable, Sequence
from typing import Any

from pinel_desktop.engine.commands import (
    KEEPALIVE,
    KEEPALIVE_PERIOD_S,
    Command,
    Evaluate,
    Stop,
)
from pinel_desktop.errors import PinelError
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import RunEnded
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.processes import own_command
from pinel_desktop.processes.messages import Message
from pinel_desktop.processes.supervisor import ProcessState, Supervisor
from pinel_desktop.robot.robot_profile import RobotProfile
from pinel_desktop.runs.robots import AT_START, HALT, JOG, ROBOT_STATE, WATCH
from pinel_desktop.runs.spec import RunSpec

EventSink = Callable[[dict[str, Any]], None]

_RESPONSE_TIMEOUT_S = 2.0
# A Stop is confirmed within milliseconds; a person who presses it must not wait long for the truth.
_CONFIRM_S = 1.0
# A Run right after an engine was replaced waits for the next one.
_READY_S = 5.0
_CONTACT_TIMEOUT_S = 40.0
_FIND_TIMEOUT_S = 15.0
# Without a new key in this time, a run may take the robot.
_HELD_S = 0.5


class EngineClient:
    """Keeps the engine process running; thread-safe. No call waits for an engine that hangs.

    `on_event` is called on the reader thread with every event, in order. When the process dies during a run, the
    client makes up the missing `run_ended` (failed, `engine_lost`; `real_engine_lost` of a real robot, which only its
    own watchdog stops then).

    Args:
        on_robot: called on the reader thread with every state of a real robot that is watched.
        is_watched: whether somebody could stop a robot: a real one stands still, and its run ends, while nobody could.
    """

    def __init__(
        self,
        on_event: EventSink,
        command: Sequence[str] | None = None,
        *,
        on_robot: EventSink = lambda state: None,
        is_watched: Callable[[], bool] = lambda: True,
    ) -> None:
        self._on_event, self._is_watched = on_event, is_watched
        self._on_robot = on_robot
        self._held_s = -math.inf
        self._process = Supervisor(
            "engine",
            command or own_command("engine"),
            "engine_silent",
            on_message=self._receive,
            on_death=self._report_loss,
            on_ready=self._on_ready,
        )
        self._bridge: tuple[Message, Callable[[Message], None]] | None = None
        self._lock = threading.RLock()
        self._live: str | None = None
        self._is_real = False
        self._next_seq = 0
        self._tick = 0

    @property
    def state(self) -> ProcessState:
        """`starting` until the process has said it is ready; `lost` when it cannot be started again."""
        return self._process.state

    @property
    def live_run(self) -> str | None:
        """Id of the run that has begun and not ended."""
        return self._live

    @property
    def pid(self) -> int | None:
        """Id of the engine's process."""
        return self._process.pid

    def start(self) -> None:
        """Starts the process; returns at once, the state tells when it is ready."""
        self._process.start()

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Waits for the process; False when it is not ready after `timeout_s`."""
        return self._process.wait_until_ready(timeout_s)

    def close(self) -> None:
        """Ends the process, which sends zero velocity first, and waits for it."""
        self._process.close()

    def run(self, run_id: str, spec: RunSpec, commands: Sequence[Command] = ()) -> None:
        """Begins a live run, whose inputs are a person's. Raises PinelError `run_in_progress` or `engine_not_ready`.

        Args:
            commands: applied before the first block begins, such as breakpoints, a speed, or a step to hold there.
        """
        if self.state == "starting":
            self.wait_until_ready(_READY_S)
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if time.monotonic() - self._held_s < _HELD_S:
                raise PinelError("robot_held_by_keys")
            if self.state == "lost":  # one more try, which the next press of Run will find
                self.start()
            if self.state != "ready":
                raise PinelError("engine_not_ready")
            first = [dict(command) for command in commands]
            self._send({"run": run_id, "spec": spec.as_message(), "commands": first})
            self._live, self._next_seq, self._tick = run_id, 0, 0
            self._is_real = spec.robot is not None
        if spec.robot is not None:
            threading.Thread(target=self._send_keepalives, args=(run_id,), daemon=True).start()

    def _send_keepalives(self, run_id: str) -> None:
        """Tells the engine that the app is not frozen and a page is open, as long as a run drives a real robot."""
        while self._live == run_id:
            if self._is_watched():
                self._process.send(KEEPALIVE)
            time.sleep(KEEPALIVE_PERIOD_S)

    def command(self, run_id: str, command: Command) -> Any:
        """Sends a command to the live run; gives the value of `Evaluate` as plain data, None for all others.

        Raises PinelError `run_not_live` when that run is not the live one, `engine_silent` when the engine does not
        take the command; for `Stop` also `stop_unconfirmed` or `real_stop_unconfirmed`; for `Evaluate` also
        `run_not_paused`, `peek_not_possible`, `peek_invalid` and what evaluating the expression raises.
        """
        if isinstance(command, Evaluate):
            return self._evaluate(run_id, command)
        if isinstance(command, Stop):
            return self._stop(run_id, command)
        with self._lock:
            if self._live != run_id:
                raise PinelError("run_not_live")
            self._send({"run": run_id, "command": dict(command)})
        return None

    def _evaluate(self, run_id: str, command: Evaluate) -> Any:
        try:
            return self._request(run_id, command, _RESPONSE_TIMEOUT_S)
        except TimeoutError as error:  # the run went on before the request's turn came
            raise PinelError("run_not_paused") from error

    def _stop(self, run_id: str, command: Stop) -> None:
        """Sends the Stop at once, then waits until the engine has it, or the run has ended."""
        unconfirmed = "real_stop_unconfirmed" if self._is_real else "stop_unconfirmed"
        try:
            self._request(run_id, command, _CONFIRM_S)
        except TimeoutError as error:
            if self._live == run_id:
                raise PinelError(unconfirmed) from error
        except PinelError as error:
            if error.code != "engine_silent":
                raise
            raise PinelError(unconfirmed) from error

    def _request(self, run_id: str, command: Command, timeout_s: float) -> Any:
        if self._live != run_id:
            raise PinelError("run_not_live")
        return self._process.request({"run": run_id, "command": dict(command)}, timeout_s)

    def contact(self, robot: RobotProfile) -> dict[str, Any]:
        """What a robot tells of itself (`runs.contact.Contact`).

        Raises PinelError `run_in_progress`, `engine_not_ready`, and what connecting with it raises.
        """
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if self.state != "ready":
                raise PinelError("engine_not_ready")
        found: dict[str, Any] = self._ask("contact", robot, _CONTACT_TIMEOUT_S)
        return found

    def find(self, robot: RobotProfile) -> list[dict[str, Any]]:
        """The robots in the domain of a record (`links.dds.finding.FoundRobot`).

        Raises PinelError `engine_not_ready`, `network_missing`, `peer_unknown`.
        """
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        found: list[dict[str, Any]] = self._ask("find", robot, _FIND_TIMEOUT_S)
        return found

    def _ask(self, what: str, robot: RobotProfile, timeout_s: float) -> Any:
        """Asks the engine about a robot, and waits for the answer."""
        try:
            return self._process.request({"type": what, "robot": robot.as_message()}, timeout_s)
        except TimeoutError as error:
            raise PinelError("engine_not_ready") from error

    def set_bridge(self, listen: Message, on_message: Callable[[Message], None]) -> None:
        """Has every engine from now on keep a bridge (`runs.bridge`); `on_message` takes what it tells and asks."""
        self._bridge = listen, on_message
        if self.state == "ready":
            self._process.send(listen)

    def send_to_bridge(self, message: Message) -> None:
        """Sends the bridge a message."""
        self._process.send(message)

    def _on_ready(self) -> None:
        if self._bridge is not None:
            self._process.send(self._bridge[0])

    def watch(self, robot: RobotProfile) -> None:
        """Lets the engine listen to a robot for some seconds longer; does nothing while it is not ready."""
        self._send_robot_message(WATCH, robot)

    def jog(self, robot: RobotProfile, drive: float, turn: float, sent_s: float) -> None:
        """Moves a robot slowly for a fifth of a second. `drive` and `turn` from -1 to 1, `sent_s` by the PC's clock.

        Raises PinelError `run_in_progress`.
        """
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if drive or turn:
                self._held_s = time.monotonic()
            self._send_robot_message(JOG, robot, drive=drive, turn=turn, sent_s=sent_s)

    def halt(self, robot: RobotProfile) -> None:
        """Stops a robot that is moved by keys."""
        self._send_robot_message(HALT, robot)

    def set_start_here(self, robot: RobotProfile) -> None:
        """The robot stands at the start of its room."""
        self._send_robot_message(AT_START, robot)

    def _send_robot_message(self, kind: str, robot: RobotProfile, **more: Any) -> None:
        if self.state == "ready":
            self._process.send({"type": kind, "robot": robot.as_message(), **more})

    def _send(self, message: Message) -> None:
        """Raises PinelError `engine_silent`."""
        if not self._process.send(message):
            raise PinelError("engine_silent")

    def _receive(self, message: Message) -> None:
        if self._bridge and message["type"].startswith("bridge_"):
            self._bridge[1](message)
        elif message.get("type") == ROBOT_STATE:
            self._on_robot(message)
        else:
            self._forward(message)

    def _forward(self, event: dict[str, Any]) -> None:
        with self._lock:
            self._next_seq, self._tick = event["seq"] + 1, event["tick"]
            if event["type"] == "run_ended" and event["run"] == self._live:
                self._live = None
        self._on_event(event)

    def _report_loss(self) -> None:
        """Reports the run that was lost with the process."""
        with self._lock:
            lost_run, seq, tick = self._live, self._next_seq, self._tick
            self._live = None
        if lost_run is not None:
            reason = "real_engine_lost" if self._is_real else "engine_lost"
            ended = RunEnded.interrupted(reason, tick / TICK_HZ)
            self._on_event(EventSequencer(lost_run, seq).wire(tick, ended))
