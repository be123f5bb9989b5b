"""Answers the requests that the engine forwards: the routes of the original PINEL."""

import base64
import json
import logging
import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pinel_desktop.engine.client import EngineClient
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.robot.robot_profile import BridgeProfile
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.web.errors import InvalidProgramError
from pinel_desktop.web.legacy import open_run
from pinel_desktop.web.legacy.execute_responses import for_each
from pinel_desktop.web.legacy.open_run import Event, ExecuteOutcome, OpenRun
from pinel_desktop.web.legacy.run_store import Commands, LegacyRunStore
from pinel_desktop.web.legacy.streams import STREAM_S, Streams
from pinel_desktop.web.responses import describe_faults, error_body, json_safe, plain, status_of
from storage import SIMULATOR, StoreError

if TYPE_CHECKING:
    from pinel_desktop.robot.robot_profile import RobotProfile
    from pinel_desktop.web.services import Services

Message = dict[str, Any]

_KEEPALIVE_PERIOD_S = 1.0
_READY_S = 40.0
_WORLD = "empty_room"
_CAPTURE: Commands = [{"action": "classify_gestures"}]
_EXAMPLE = '[{"action": "move_forward", "distance": 1}]'
_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class BridgeChoice:
    """Address of the bridge, and the robot that its calls drive.

    Attributes:
        robot: name of the link; `bridge` is the program that asks this bridge for velocities.
        file_pages: True if pages opened from a `file:` address are answered without a key.
    """

    profile: BridgeProfile
    robot: str = SIMULATOR
    file_pages: bool = False


class LegacyApi:
    """The routes of the original PINEL. Thread-safe; each request is answered on a thread of its own."""

    def __init__(
        self,
        parts: "Services",
        engine: EngineClient,
        choice: BridgeChoice,
        schedule: Callable[[float, Callable[[], None]], open_run.Cancel] = open_run.by_timer,
    ) -> None:
        self._parts, self._engine, self._choice = parts, engine, choice
        store = LegacyRunStore(parts.store, parts.app_version, lambda: parts.settings.language)
        self._run = OpenRun(engine, store, self._spec, self._check, schedule)
        self._streams = Streams(self._run, parts.camera, self._caption)
        self._batch: int | None = None
        self._routes: dict[str, tuple[str, int, Callable[[Message, threading.Event], Message]]] = {
            "/execute": ("POST", MAX_BYTES, self._execute),
            "/classify_gestures": ("POST", MAX_BYTES, self._classify),
            "/get_last_gesture_result": ("GET", 0, self._last_result),
            "/classify_stream": ("GET", 0, self._picture),
        }
        self._open: dict[str, threading.Event] = {}
        self._closing = threading.Event()
        self._listening = threading.Event()
        self._port, self._problem = 0, PinelError("engine_not_ready")

    def start(self) -> None:
        """Makes the engine listen."""
        routes = {
            path: {"method": method, "max_body": max_body}
            for path, (method, max_body, _) in self._routes.items()
        }
        record = self._choice.profile.as_message()
        listen = {
            "type": "bridge_listen",
            "record": record,
            "routes": routes,
            "file_pages": self._choice.file_pages,
        }
        self._parts.camera.start()  # a page waits only 10 s for a sign
        self._engine.set_bridge(listen, self.receive)
        threading.Thread(target=self._send_keepalives, name="bridge-alive", daemon=True).start()

    def wait_until_listening(self) -> str:
        """Returns the address, such as `http://127.0.0.1:5000`.

        Raises PinelError with the reason if the engine does not listen.
        """
        if not self._listening.wait(_READY_S) or not self._port:
            raise self._problem
        return f"http://{self._choice.profile.url_host}:{self._port}"

    def close(self) -> None:
        """Stops answering requests."""
        self._closing.set()
        self._run.close()

    @property
    def is_watched(self) -> bool:
        """True if a person can stop the robot of a call, as `OpenRun.is_watched`."""
        return self._run.is_watched

    def observe(self, event: Event) -> None:
        """Handles an event of a live run. Must be called for every event, in order, after the store has it."""
        self._run.observe(event)

    def receive(self, message: Message) -> None:
        """Handles messages of the bridge (`runs.bridge`); called on the engine's reader thread."""
        match message["type"]:
            case "bridge_asked":
                self._open[message["question"]] = threading.Event()
                threading.Thread(target=self._respond, args=(message,), daemon=True).start()
            case "bridge_withdrawn":
                if withdrawn := self._open.get(message["question"]):
                    withdrawn.set()
            case "bridge_batch_ended":
                self._run.wait_less()
            case "bridge_listens":
                self._port = message["port"]
                self._listening.set()
            case "bridge_refused":
                self._problem = PinelError(message["code"], **message["params"])
                self._listening.set()

    def _respond(self, message: Message) -> None:
        number = message["question"]
        withdrawn = self._open[number]
        _, _, work = self._routes[message["path"]]
        try:
            answer = work(message, withdrawn)
        except (PinelError, StoreError) as error:
            answer = self._refusal(error)
        except Exception as error:
            _log.exception("%s failed", message["path"])
            answer = self._refusal(PinelError("internal_error", detail=type(error).__name__))
        del self._open[number]
        if not withdrawn.is_set():
            self._engine.send_to_bridge({"type": "bridge_answer", "question": number, **answer})

    def _send_keepalives(self) -> None:
        while not self._closing.wait(_KEEPALIVE_PERIOD_S):
            if self._open:
                self._engine.send_to_bridge({"type": "bridge_alive"})

    def _execute(self, message: Message, withdrawn: threading.Event) -> Message:
        body = message["body"].encode("utf-8", "surrogateescape")
        commands = self._commands(body)
        outcome = self._call(commands, message, withdrawn)
        report = self._report(outcome)
        if message["of_page"] and outcome is not None:
            return _ok_response(for_each(json.loads(body), outcome, report.get("error")))
        return _ok_response(report)

    def _classify(self, message: Message, withdrawn: threading.Event) -> Message:
        outcome = self._call(_CAPTURE, message, withdrawn)
        report = self._report(outcome)
        is_done = outcome is not None and outcome.state == "ok"
        return _ok_response({"result": self._run.result or ""} if is_done else report)

    def _call(
        self, commands: Commands, message: Message, withdrawn: threading.Event
    ) -> ExecuteOutcome | None:
        """Executes a call and returns its outcome.

        If a stream has already started a capture, a call of one capture gets the outcome of that capture.
        """
        if (capture := self._streams.current()) is not None:
            self._streams.settle()
            capture.over.wait(STREAM_S)
            is_joined = len(commands) == 1 and commands[0]["action"] == _CAPTURE[0]["action"]
            if is_joined and capture.outcome is not None:
                return capture.outcome
        if ended := self._ended_in(message["batch"] if message["of_page"] else None):
            return ended
        return self._run.call(commands, withdrawn)

    def _ended_in(self, batch: int | None) -> ExecuteOutcome | None:
        """Returns the reason why the rest of a page's batch is not executed; None to execute it.

        The original's page sends the next command of its batch even after a Stop.
        """
        ended = self._run.cut_short
        if batch is None or batch != self._batch:
            self._batch, self._run.cut_short = batch, None
        elif ended is not None:
            return ExecuteOutcome(ended.state, 0, ended.code, ended.params)
        return None

    def _last_result(self, message: Message, withdrawn: threading.Event) -> Message:
        self._streams.settle()
        return _ok_response({"resultado": self._run.result})

    def _picture(self, message: Message, withdrawn: threading.Event) -> Message:
        may_capture = self._ended_in(message["batch"]) is None
        picture = self._streams.picture(message["request"], may_capture=may_capture)
        if picture is None:
            return _ok_response({})
        return {"status": 200, "jpeg": base64.b64encode(picture).decode("ascii")}

    def _caption(self, result: str | None) -> str:
        code = "bridge_capture" if result is None else "bridge_sign" if result else "bridge_no_sign"
        values = {"sign": result} if result else {}
        return describe(code, values, self._parts.settings.language).message

    def _commands(self, body: bytes) -> Commands:
        """Reads the commands of a call.

        Raises PinelError `invalid_program` with all faults, and `bridge_list_needed`.
        """
        from pinel_desktop.program.reading import read_document  # noqa: PLC0415 - heavy
        from pinel_desktop.runs.robot_checks import missing_on_real_robots  # noqa: PLC0415

        reading = read_document(body)
        if reading.document is None:
            raise self._invalid(reading.faults)
        if not body.lstrip().startswith(b"["):
            raise PinelError("bridge_list_needed", example=_EXAMPLE)
        commands: Commands = reading.document["commands"]
        if self._choice.robot != SIMULATOR and (faults := missing_on_real_robots(commands)):
            raise self._invalid(faults)
        self._parts.camera.start()  # so that it is ready for the first capture
        return commands

    def _check(self, commands: Commands) -> None:
        """Raises PinelError `invalid_program` if a run has too many commands."""
        from pinel_desktop.program.reading import read_document  # noqa: PLC0415 - heavy

        if faults := read_document({"pinel_ir": 1, "commands": commands}).faults:
            raise self._invalid(faults)

    def _spec(self, document: dict[str, Any]) -> RunSpec:
        if self._choice.robot == SIMULATOR:
            world = next(one for one in self._parts.worlds if one["name"] == _WORLD)
            return RunSpec(document, world, pace="live")
        robot = self._robot()
        world = robot.room.as_world()
        return RunSpec(document, world, link=robot.link, robot=robot, pace="live")

    def _robot(self) -> "RobotProfile":
        """Returns the robot's profile. Raises PinelError `robot_not_set_up`; the link `bridge` needs no set-up."""
        record, robots = self._choice.profile, self._parts.robots
        if self._choice.robot != record.link:
            return robots.profile(self._choice.robot)
        stored = robots.find(record.link) or record
        return stored.model_copy(
            update={"host": record.host, "port": self._port, "key": record.key}
        )

    def _invalid(self, faults: Any) -> InvalidProgramError:
        return InvalidProgramError(describe_faults(faults, self._parts.settings.language))

    def _report(self, outcome: ExecuteOutcome | None) -> dict[str, Any]:
        """Returns the body of a call's response; empty if the caller has disconnected."""
        if outcome is None:
            return {}
        report: dict[str, Any] = {"status": outcome.state, "n_executed": outcome.n_executed}
        if outcome.code is None:
            return report
        text = describe(outcome.code, outcome.params, self._parts.settings.language)
        error = {"code": outcome.code, "message": text.message, "remedy": text.remedy}
        return {**report, "error": {**error, "params": json_safe(outcome.params)}}

    def _refusal(self, error: PinelError | StoreError) -> Message:
        faults = getattr(error, "faults", ())
        language = self._parts.settings.language
        body = error_body(error.code, error.params, language, faults=faults)
        status = 503 if error.code.startswith("camera_") else status_of(error.code)
        return {"status": status, "document": {"error": plain(body)}}


def _ok_response(document: dict[str, Any] | list[dict[str, Any]]) -> Message:
    return {"status": 200, "document": document}
