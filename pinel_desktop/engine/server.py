"""The engine process: reads messages, executes one live run at a time, writes its events."""

import contextlib
import gc
import logging
import threading
from collections.abc import Callable
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any, BinaryIO

from pydantic import ValidationError

from pinel_desktop.engine.commands import KEEPALIVE, Command, EngineCommand
from pinel_desktop.errors import PinelError
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, RunEnded
from pinel_desktop.execution.control import RunControl
from pinel_desktop.processes.messages import (
    PING,
    PONG,
    Message,
    read_messages,
    response,
    write_message,
)
from pinel_desktop.robot import RobotLink
from pinel_desktop.robot.robot_profile import RobotProfile, profile_from
from pinel_desktop.runs.fixed_inputs import FixedInputs
from pinel_desktop.runs.robots import ROBOT_MESSAGES
from pinel_desktop.runs.spec import RunSpec, spec_from
from pinel_desktop.runs.start import all_of, start

if TYPE_CHECKING:
    from pinel_desktop.runs.bridge import BridgeController
    from pinel_desktop.runs.robots.service import RobotService

_log = logging.getLogger(__name__)
_EMPTY_SHA256 = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"
# When the pipe ends, a run stops its robot within a second. A longer time-out would only keep an
# engine without an app alive.
_STOP_TIMEOUT_S = 3.0


class _LiveRun:
    """One run on its own thread."""

    def __init__(self, message: Message, engine: "Engine", former: threading.Thread | None) -> None:
        self.id = str(message["run"])
        self.control = RunControl()
        self._message, self._engine, self._former = message, engine, former
        self._sequencer = EventSequencer(self.id)
        self.thread = threading.Thread(target=self._work, name=f"run-{self.id}", daemon=True)
        if message["spec"].get("robot"):
            self.control.record_keepalive()  # the first one: it starts the time-out
        for command in message.get("commands", ()):
            self.apply(EngineCommand.model_validate(command).root, None)

    def apply(self, command: Command, request: int | None) -> None:
        """Applies a command of the app to the run; `request` is the number of the response, None without one."""

        def reply(value: Any, error: PinelError | None) -> None:
            if request is not None:
                self._engine.respond(request, value, error)

        command.apply(self.control, reply)

    def _work(self) -> None:
        if self._former is not None:  # may still be ending; the reading thread must not wait for it
            self._former.join(_STOP_TIMEOUT_S)
            self._former = None
        self._execute()
        # `start` freezes and unfreezes the existing objects (`gc.freeze`), which puts them into the
        # oldest generation. The collector would not examine that generation by itself.
        gc.collect()

    def _execute(self) -> None:
        try:
            given = self._message.get("inputs")
            inputs = FixedInputs.from_message(given).source() if given else self.control.inputs
            spec = spec_from(self._message["spec"], inputs)
            if spec.robot is None:
                start(spec, self._observe, self.control)
                return
            with self._engine.robots.reserved(spec.robot) as follow:
                self._drive(spec, follow)
        except PinelError as error:  # before the first tick: unknown world, faults in the document
            self._observe(0, _start_failure(error))
        except OSError:
            _log.warning("the pipe for the events of run %s is closed", self.id)

    def _drive(self, spec: RunSpec, follow: Callable[[RobotLink], None]) -> None:
        from pinel_desktop.runs.robots.localised import LocalisationSender  # noqa: PLC0415 - for real robots only

        assert spec.robot is not None
        localisation = LocalisationSender(self.id, spec.robot, self._engine.send)

        def use(link: RobotLink) -> None:
            follow(link)
            localisation.follow(link)

        observe = all_of(self._observe, localisation.observe if localisation.is_read else None)
        start(spec, observe, self.control, on_link=use)

    def _observe(self, tick: int, event: Event) -> None:
        self._engine.send(self._sequencer.wire(tick, event))


def _start_failure(error: PinelError) -> RunEnded:
    return RunEnded(
        state="failed",
        reason=error.code,
        params=error.params,
        block=None,
        n_executed=0,
        duration_s=0.0,
        path_length_m=0.0,
        closing_error_m=0.0,
        pose=None,
        telemetry_sha256=_EMPTY_SHA256,
        estimated_closing_error_m=0.0,
    )


class Engine:
    """Reads messages from one pipe and writes events to another, until the first one ends."""

    def __init__(self, messages: BinaryIO, events: BinaryIO) -> None:
        self._messages, self._events = messages, events
        self._writing = threading.Lock()
        self._responses: SimpleQueue[Message] = SimpleQueue()
        self._live: _LiveRun | None = None
        self._bridge: BridgeController | None = None
        self._making = threading.Lock()
        self._robots: RobotService | None = None
        # requests of the app about a real robot
        self._robot_queries = {"contact": self._contact, "find": self._find}

    @property
    def robots(self) -> "RobotService":
        """The service for real robots; the first access imports and creates it."""
        from pinel_desktop.runs.robots.service import RobotService  # noqa: PLC0415 - for real robots only

        with self._making:
            self._robots = self._robots or RobotService(self.send)
            return self._robots

    def send(self, message: Message) -> None:
        """Writes an event; safe from any thread."""
        with self._writing:
            write_message(self._events, message)

    def respond(self, request: int, value: Any = None, error: PinelError | None = None) -> None:
        """Queues the response to a request of the app; never waits for an app that does not read."""
        self._responses.put(response(request, value, error))

    def _send_responses(self) -> None:
        """Writes queued responses, on its own thread: a full pipe must not keep the reading thread from Stop."""
        with contextlib.suppress(OSError):  # the app has exited
            while True:
                self.send(self._responses.get())

    def serve(self) -> None:
        """Handles messages until the pipe ends, then stops the robot."""
        threading.Thread(target=self._send_responses, name="answers", daemon=True).start()
        EngineCommand.model_rebuild()  # here, so that the first Stop does not wait for it
        self.send({"type": "engine_ready"})
        try:
            for message in read_messages(self._messages):
                self._handle(message)
        finally:
            self._stop_and_wait()
            if self._bridge is not None:
                self._bridge.close()
            if self._robots is not None:
                self._robots.close()

    def _handle(self, message: Message) -> None:
        live, kind = self._live, str(message.get("type"))
        if message == PING:
            self._responses.put(PONG)
            return
        if "spec" in message:
            self._begin(message)
            return
        if kind in self._robot_queries:
            threading.Thread(
                target=self._respond_to_robot_query, args=(message,), daemon=True
            ).start()
            return
        if kind in ROBOT_MESSAGES:
            self.robots.handle(message)
            return
        if live is not None and kind == KEEPALIVE["type"]:
            live.control.record_keepalive()
            return
        if kind.startswith("bridge_"):
            self._steer_bridge(message)
            return
        request = message.get("request")
        if live is None or message.get("run") != live.id:  # a run of the engine before this one
            if request is not None:
                self.respond(request, error=PinelError("run_not_live"))
            return
        try:
            command = EngineCommand.model_validate(message.get("command"))
        except ValidationError:
            _log.warning("an unknown command was ignored: %s", message)
            return
        live.apply(command.root, request)

    def _steer_bridge(self, message: Message) -> None:
        if self._bridge is None:
            from pinel_desktop.runs.bridge import BridgeController  # noqa: PLC0415 - for a bridge only

            self._bridge = BridgeController(self.send)
        self._bridge.handle(message)

    def _respond_to_robot_query(self, message: Message) -> None:
        """Responds to a request about a real robot, on its own thread."""
        try:
            found = self._robot_queries[message["type"]](profile_from(message["robot"]))
        except PinelError as error:
            self.respond(message["request"], error=error)
        else:
            self.respond(message["request"], found)

    def _contact(self, profile: RobotProfile) -> Message:
        from pinel_desktop.runs.contact import probe_robot  # noqa: PLC0415 - for real robots only

        with self.robots.reserved(profile):
            return probe_robot(profile).as_message()

    def _find(self, profile: RobotProfile) -> list[Message]:
        from pinel_desktop.runs.contact import robots_in_domain  # noqa: PLC0415 - for real robots only

        return robots_in_domain(profile)

    def _begin(self, message: Message) -> None:
        # The app starts one run at a time, but the thread of the former run may still be ending.
        former = self._live
        if former is not None:
            former.control.stop()
        self._live = _LiveRun(message, self, former.thread if former else None)
        self._live.thread.start()

    def _stop_and_wait(self) -> None:
        if self._live is not None:
            self._live.control.stop()
            self._live.thread.join(_STOP_TIMEOUT_S)
