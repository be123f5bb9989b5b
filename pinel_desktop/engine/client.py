"""The app's side of the engine: supervises its process, sends messages to it and forwards its events."""

import math
import threading
import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

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
from pinel_desktop.runs.robots import AT_START, HALT, JOG, LOCALISED, ROBOT_STATE, WATCH
from pinel_desktop.runs.spec import RunSpec

if TYPE_CHECKING:
    from pinel_desktop.runs.fixed_inputs import FixedInputs

EventSink = Callable[[dict[str, Any]], None]

_RESPONSE_TIMEOUT_S = 2.0
# An engine confirms Stop within milliseconds. A longer time-out would only delay the error message.
_CONFIRM_S = 1.0
# A Run that is pressed right after the engine was replaced waits for the new engine.
_READY_S = 5.0
_CONTACT_TIMEOUT_S = 40.0
_FIND_TIMEOUT_S = 15.0
# A run may start once no key has moved the robot for this time.
_HELD_S = 0.5


class EngineClient:
    """Supervises the engine process; thread-safe. Every call has a time-out, so a hung engine blocks nobody.

    `on_event` is called on the reader thread with every event, in order. If the process dies during a run, the client
    creates the missing `run_ended` with state `failed`. Its reason is `engine_lost`, or `real_engine_lost` for a real
    robot, which then only its own watchdog stops.

    Args:
        on_robot: called on the reader thread with every state of a watched real robot.
        on_localised: called on the reader thread with what a robot's own localisation says during a run.
        is_watched: returns whether a person could press Stop. While it returns False, the client sends no keepalives;
            the engine then stops a real robot and ends its run.
    """

    def __init__(
        self,
        on_event: EventSink,
        command: Sequence[str] | None = None,
        *,
        on_robot: EventSink = lambda state: None,
        on_localised: EventSink = lambda message: None,
        is_watched: Callable[[], bool] = lambda: True,
    ) -> None:
        self._on_event, self._is_watched = on_event, is_watched
        self._on_robot, self._on_localised = on_robot, on_localised
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
        """`starting` until the process has reported that it is ready; `lost` if it cannot be restarted."""
        return self._process.state

    @property
    def live_run(self) -> str | None:
        """Id of the live run; None without one."""
        return self._live

    @property
    def pid(self) -> int | None:
        """Process id of the engine."""
        return self._process.pid

    def start(self) -> None:
        """Starts the process and returns at once; `state` becomes `ready` later."""
        self._process.start()

    def wait_until_ready(self, timeout_s: float) -> bool:
        """Waits for the process; returns False if it is not ready after `timeout_s`."""
        return self._process.wait_until_ready(timeout_s)

    def close(self) -> None:
        """Ends the process and waits for its exit; the process sends zero velocity first."""
        self._process.close()

    def run(
        self,
        run_id: str,
        spec: RunSpec,
        commands: Sequence[Command] = (),
        inputs: "FixedInputs | None" = None,
    ) -> None:
        """Starts a live run, whatever inputs its spec has.

        Raises PinelError `run_in_progress`, `robot_held_by_keys`, `engine_not_ready`, `engine_silent`.

        Args:
            commands: applied before the first block starts: for example breakpoints, a speed, or a step that pauses
                at the first block.
            inputs: what the program reads; None if a person gives it.
        """
        self._prepare()
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if time.monotonic() - self._held_s < _HELD_S:
                raise PinelError("robot_held_by_keys")
            if self.state != "ready":
                raise PinelError("engine_not_ready")
            first = [dict(command) for command in commands]
            given = inputs and inputs.as_message()
            message = {"run": run_id, "spec": spec.as_message(), "inputs": given}
            self._send({**message, "commands": first})
            self._live, self._next_seq, self._tick = run_id, 0, 0
            self._is_real = spec.robot is not None
        if spec.robot is not None:
            threading.Thread(target=self._send_keepalives, args=(run_id,), daemon=True).start()

    def _send_keepalives(self, run_id: str) -> None:
        """Sends keepalives while the run drives a real robot and `is_watched` returns True."""
        while self._live == run_id:
            if self._is_watched():
                self._process.send(KEEPALIVE)
            time.sleep(KEEPALIVE_PERIOD_S)

    def command(self, run_id: str, command: Command) -> Any:
        """Sends a command to the live run. Returns the value of `Evaluate` as plain data, else None.

        Raises PinelError `run_not_live` if that run is not the live one, and `engine_silent` if the engine does not
        accept the command. For `Stop` also `stop_unconfirmed` or `real_stop_unconfirmed`. For `Evaluate` also
        `run_not_paused`, `peek_not_possible`, `peek_invalid` and the errors of the evaluation.
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
        except TimeoutError as error:  # the run resumed before it processed the request
            raise PinelError("run_not_paused") from error

    def _stop(self, run_id: str, command: Stop) -> None:
        """Sends Stop at once, then waits for the engine's confirmation or the end of the run."""
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
        """Connects with a robot and returns its report about itself (`runs.contact.Contact`).

        Raises PinelError `run_in_progress`, `engine_not_ready`, and the errors of the connection.
        """
        self._prepare()
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if self.state != "ready":
                raise PinelError("engine_not_ready")
        found: dict[str, Any] = self._ask("contact", robot, _CONTACT_TIMEOUT_S)
        return found

    def find(self, robot: RobotProfile) -> list[dict[str, Any]]:
        """Returns the robots in the DDS domain of a profile (`links.dds.discovery.DiscoveredRobot`).

        Raises PinelError `engine_not_ready`, `network_missing`, `peer_unknown`.
        """
        self._prepare()
        if self.state != "ready":
            raise PinelError("engine_not_ready")
        found: list[dict[str, Any]] = self._ask("find", robot, _FIND_TIMEOUT_S)
        return found

    def _prepare(self) -> None:
        """Starts a lost engine again, and waits a few seconds for one that starts."""
        if self.state == "lost":
            self.start()
        if self.state == "starting":
            self.wait_until_ready(_READY_S)

    def _ask(self, what: str, robot: RobotProfile, timeout_s: float) -> Any:
        """Sends a request about a robot and returns the response."""
        try:
            return self._process.request({"type": what, "robot": robot.as_message()}, timeout_s)
        except TimeoutError as error:
            raise PinelError("engine_not_ready") from error

    def set_bridge(self, listen: Message, on_message: Callable[[Message], None]) -> None:
        """Makes this engine and all later ones run a bridge (`runs.bridge`).

        Args:
            listen: the message that starts the bridge; sent again to each new engine.
            on_message: receives the messages of the bridge.
        """
        self._bridge = listen, on_message
        if self.state == "ready":
            self._process.send(listen)

    def send_to_bridge(self, message: Message) -> None:
        """Sends a message to the bridge."""
        self._process.send(message)

    def _on_ready(self) -> None:
        if self._bridge is not None:
            self._process.send(self._bridge[0])

    def watch(self, robot: RobotProfile) -> None:
        """Makes the engine observe a robot for a few more seconds; has no effect while the engine is not ready."""
        self._send_robot_message(WATCH, robot)

    def jog(self, robot: RobotProfile, drive: float, turn: float, sent_s: float) -> None:
        """Moves a robot slowly for 0.2 s.

        Raises PinelError `run_in_progress`.

        Args:
            drive, turn: fraction of the jogging speed, from -1 to 1; positive is ahead and to the left.
            sent_s: time at which the page sent it, by the PC's clock (s since 1970).
        """
        with self._lock:
            if self._live is not None:
                raise PinelError("run_in_progress")
            if drive or turn:
                self._held_s = time.monotonic()
            self._send_robot_message(JOG, robot, drive=drive, turn=turn, sent_s=sent_s)

    def halt(self, robot: RobotProfile) -> None:
        """Stops a robot that keys move."""
        self._send_robot_message(HALT, robot)

    def set_start_here(self, robot: RobotProfile) -> None:
        """Sets the robot's current pose as the start of its room."""
        self._send_robot_message(AT_START, robot)

    def _send_robot_message(self, kind: str, robot: RobotProfile, **more: Any) -> None:
        if self.state == "ready":
            self._process.send({"type": kind, "robot": robot.as_message(), **more})

    def _send(self, message: Message) -> None:
        """Sends a message. Raises PinelError `engine_silent` if it cannot be sent."""
        if not self._process.send(message):
            raise PinelError("engine_silent")

    def _receive(self, message: Message) -> None:
        if self._bridge and message["type"].startswith("bridge_"):
            self._bridge[1](message)
        elif message.get("type") == ROBOT_STATE:
            self._on_robot(message)
        elif message["type"] == LOCALISED:
            self._on_localised(message)
        else:
            self._forward(message)

    def _forward(self, event: dict[str, Any]) -> None:
        with self._lock:
            self._next_seq, self._tick = event["seq"] + 1, event["tick"]
            if event["type"] == "run_ended" and event["run"] == self._live:
                self._live = None
        self._on_event(event)

    def _report_loss(self) -> None:
        """Ends the live run as failed after the process has died."""
        with self._lock:
            lost_run, seq, tick = self._live, self._next_seq, self._tick
            self._live = None
        if lost_run is not None:
            reason = "real_engine_lost" if self._is_real else "engine_lost"
            ended = RunEnded.interrupted(reason, tick / TICK_HZ)
            self._on_event(EventSequencer(lost_run, seq).wire(tick, ended))
