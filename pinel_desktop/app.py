"""Composition root: the only place where store, engine, hub and web are wired together.

`_warm_up` later imports the modules that the first drawing of the page does not need.
"""

import contextlib
import logging
import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pinel_desktop import __version__
from pinel_desktop.app_database import WRITABLE_NOTICES, open_database
from pinel_desktop.camera.client import CameraClient, CameraState
from pinel_desktop.cloud.client import CloudClient
from pinel_desktop.database_locations import forget_location
from pinel_desktop.engine.client import EngineClient
from pinel_desktop.events.app_events import CameraChanged, Notice
from pinel_desktop.events.hub import Hub
from pinel_desktop.events.types import RECORDED, URGENT
from pinel_desktop.execution.inputs import Capture
from pinel_desktop.instance import InstanceLock
from pinel_desktop.links import LINK_NAMES
from pinel_desktop.messages import Problem, describe, explain
from pinel_desktop.messages.content import titled
from pinel_desktop.school.confirming import Confirmer
from pinel_desktop.school.detectors import Detectors
from pinel_desktop.school.grading import Grader
from pinel_desktop.school.live_checks import LiveChecks
from pinel_desktop.school.opened_file import OpenedFile
from pinel_desktop.school.predictions import Predictions
from pinel_desktop.school.robot_profiles import RobotProfiles
from pinel_desktop.school.robot_status_feed import RobotStatusFeed
from pinel_desktop.school.sign_teaching import SignTeaching
from pinel_desktop.school.teacher import TeacherSessions
from pinel_desktop.school.truths.floor_camera import FloorCamera
from pinel_desktop.school.truths.localisation import LocalisationTruth
from pinel_desktop.school.truths.overhead import OverheadTruth
from pinel_desktop.settings import CAMERA, Settings
from pinel_desktop.web.application import create_app
from pinel_desktop.web.early_server import EarlyServer
from pinel_desktop.web.services import DatabaseState, Services, WindowLink
from sim.world import list_worlds
from storage import Notice as StoreNotice
from storage import RunRecorder, StoreError, warm_up
from storage.file.temporary import remove_leftovers
from storage.maintenance import Maintenance

if TYPE_CHECKING:
    from pinel_desktop.judge.messages import RunStartInfo
    from pinel_desktop.web.legacy.api import BridgeChoice, LegacyApi

Event = dict[str, Any]
_log = logging.getLogger(__name__)
_FLUSH_TIMEOUT_S = 2.0
_INTERRUPTED = {"state": "failed", "reason": "interrupted"}


class App:
    """The backend of the page. Call `start`, pass `address` to a window or a person, then `close`.

    Args:
        database: the database file, created if missing. If it cannot be used, the app starts, and the page shows why.
        port: port of the page; 0 for any free port.
        early_server: server that already serves the page; the app closes it.
        instance: lock on the database that the caller has acquired; the app releases it.
        engine_after_s: how long the engine and the modules for the first edit and run wait for a page that reads the
            events, in s. On a PC with two cores, loading them at once would delay the first drawing of the page.
        window: the app's window; None without one.
        camera: address of a camera instead of the chosen webcam, as for `camera.frames.open_reader`.
        recognizer: name of a recognizer of signs instead of the chosen one, as for `recognizers.open_recognizer`.
        bridge: where the original PINEL's HTTP interface is served, and which robot its calls drive; None: nowhere.
        opened: path of the file with which a person has opened the app.
    """

    def __init__(  # noqa: PLR0913 - parts that the window and tests replace
        self,
        database: Path,
        *,
        port: int = 0,
        early_server: EarlyServer | None = None,
        instance: InstanceLock | None = None,
        engine_after_s: float = 0.0,
        window: WindowLink | None = None,
        make_engine: Callable[..., EngineClient] = EngineClient,
        camera: str | None = None,
        recognizer: str | None = None,
        bridge: "BridgeChoice | None" = None,
        opened: str | None = None,
    ) -> None:
        self._database = database
        self._port = port
        self._early_server = early_server
        self._instance = instance
        self._engine_after_s = engine_after_s
        self._window = window
        self._make_engine = make_engine
        self._camera_source, self._recognizer = camera, recognizer
        self._bridge = bridge
        self._opened = opened
        self._legacy: LegacyApi | None = None
        self._closing = contextlib.ExitStack()

    def start(self) -> None:
        """Starts all parts; if one cannot start, closes the others.

        Raises:
            AlreadyRunningError: another process serves this database.
            PinelError: `port_taken`, `instance_silent`.
        """
        with contextlib.ExitStack() as undo:
            instance = self._instance or InstanceLock(self._database)
            if self._instance is None:
                instance.acquire()
            undo.callback(instance.release)
            self._assemble(undo)
            instance.announce(self._guard.origin, self._guard.secret)
            undo.callback(_log.info, "the app ends")
            self._closing = undo.pop_all()
        _log.info("the app has started; notice: %s", self.notice and self.notice.code)

    @property
    def address(self) -> str:
        """A new address that opens the page once."""
        return self._guard.fresh_link()

    @property
    def language(self) -> str:
        """The chosen language of page and messages."""
        return self._settings.language

    @property
    def notice(self) -> Problem | None:
        """The notice about the database for people; None if there is no problem."""
        return self._database_state().notice

    def wait_for_bridge(self) -> str | None:
        """Waits until the bridge listens; returns its address, None without a bridge.

        Raises:
            PinelError: the bridge cannot listen.
        """
        return self._legacy.wait_until_listening() if self._legacy else None

    def close(self) -> None:
        """Stops the robot, writes pending data, ends all event streams. Safe to call twice."""
        self._closing.close()

    def __enter__(self) -> "App":
        self.start()
        return self

    def __exit__(self, *failure: object) -> None:
        self.close()

    def _assemble(self, undo: contextlib.ExitStack) -> None:
        """Creates the parts, which end in reverse order: engine, hub, server, recorder, last backup, store."""
        self._open_store(undo)
        self._hub = Hub()
        self._create_recording(undo)
        server = self._early_server or EarlyServer(self._port, self._settings)
        undo.callback(server.close)
        undo.callback(self._hub.close)
        self._guard = server.guard
        self._create_devices(undo)
        services = self._services()
        server.open(create_app(services))
        self._serve_bridge(services, undo)
        self._maintenance.start()
        self._content_check.start()
        self._start_engine(undo)

    def _open_store(self, undo: contextlib.ExitStack) -> None:
        self._store = open_database(self._database)
        undo.callback(self._store.close)
        self._maintenance = Maintenance(self._store, self._publish_storage_notice)
        undo.callback(self._maintenance.back_up_at_the_end)  # runs after all other writes
        early = self._early_server
        self._settings = early.settings if early else Settings.beside(self._database)
        with contextlib.suppress(StoreError):
            self._settings.import_from_database(self._store.settings.get)

    def _create_recording(self, undo: contextlib.ExitStack) -> None:
        """Creates what records, judges and checks."""
        self._recorder = RunRecorder(
            self._store, self._publish_recording, recorded=RECORDED, urgent=URGENT
        )
        undo.callback(self._end_recording)
        self._grader = Grader(
            self._store, self._flush_recording, self._hub.publish, lambda: self._settings.language
        )
        self._confirmer = Confirmer(self._store, self._grader.verdict_on, self._grader.grade)
        undo.callback(self._confirmer.close)
        self._live_checks = LiveChecks(
            lambda: self._grader.judge, self._hub.publish, lambda: self._settings.language
        )
        undo.callback(self._live_checks.close)
        undo.callback(self._grader.close)  # ends the judge, for which the others may wait
        undo.callback(self._maintenance.close)
        self._content_check = self._store.scrubber(self._publish_storage_notice)
        undo.callback(self._content_check.close)
        if self._store.unfinished:
            self._recorder.flush()  # retries until the disk has free space

    def _create_devices(self, undo: contextlib.ExitStack) -> None:
        """Creates engine, camera, and what belongs to them."""
        self._status_feed = RobotStatusFeed(self._hub.publish, lambda: self._settings.language)
        self._localisation = LocalisationTruth(
            self._store, self._hub.publish, lambda: self._settings.language
        )
        self._floor_camera = FloorCamera(self._settings)
        self._overhead = OverheadTruth(
            self._store, self._floor_camera, self._hub.publish, lambda: self._settings.language
        )
        # after the engine, whose end may end a run
        undo.callback(self._localisation.close)
        undo.callback(self._overhead.close)
        self._engine = self._make_engine(
            self._on_engine_event,
            on_robot=self._status_feed.publish_state,
            on_localised=self._localisation.receive,
            is_watched=self._is_watched,
        )
        undo.callback(self._engine.close)
        self._camera = CameraClient(
            self._camera_source or self._settings[CAMERA],
            self._hub.publish,
            self._publish_camera,
            self._answer_capture,
            on_recognizer=lambda state: self._signs.refresh(),
            on_overhead=self._overhead.receive,
        )
        self._floor_camera.use(self._camera)
        undo.callback(self._camera.close)
        self._signs = SignTeaching(
            self._store, self._camera, self._hub.publish, lambda: self._settings.language
        )
        self._cloud = CloudClient(self._hub.publish, lambda: self._settings.language)
        undo.callback(self._cloud.close)
        self._detectors = Detectors(
            self._database.with_name("detectors"), self._settings, self._camera, self._recognizer
        )

    def _serve_bridge(self, services: Services, undo: contextlib.ExitStack) -> None:
        if self._bridge is None:
            return
        from pinel_desktop.web.legacy.api import LegacyApi  # noqa: PLC0415 - only with a bridge

        self._legacy = LegacyApi(services, self._engine, self._bridge)
        undo.callback(self._legacy.close)
        self._legacy.start()

    def _is_watched(self) -> bool:
        return self._hub.has_readers() or (self._legacy is not None and self._legacy.is_watched)

    def _start_engine(self, undo: contextlib.ExitStack) -> None:
        if not self._engine_after_s:
            self._engine.start()
            self._start_judging()
            return

        is_closing = threading.Event()

        def start() -> None:
            self._hub.first_reader.wait(self._engine_after_s)
            if not is_closing.is_set():
                self._engine.start()
                _warm_up()
                self._start_judging()

        starter = threading.Thread(target=start, name="engine-start")
        starter.start()
        undo.callback(starter.join)
        undo.callback(self._hub.first_reader.set)
        undo.callback(is_closing.set)

    def _start_judging(self) -> None:
        """Judges runs that the last start left unjudged, and re-verifies runs from merged files."""
        self._grader.catch_up()
        self._confirmer.start()

    def _services(self) -> Services:
        return Services(
            app_version=__version__,
            store=self._store,
            engine=self._engine,
            camera=self._camera,
            detectors=self._detectors,
            signs=self._signs,
            cloud=self._cloud,
            overhead=self._overhead,
            floor_camera=self._floor_camera,
            localisation=self._localisation,
            hub=self._hub,
            guard=self._guard,
            settings=self._settings,
            teacher=TeacherSessions(self._store.settings),
            robots=RobotProfiles(self._store.settings, LINK_NAMES),
            status_feed=self._status_feed,
            predictions=Predictions(self._store, lambda: self._grader.judge),
            opened_file=OpenedFile(self._hub.publish, self._opened),
            worlds=[titled(world) for world in list_worlds()],
            database_state=self._database_state,
            window=self._window,
            flush_recording=self._flush_recording,
            prepare_judge=self._prepare_judge,
            confirm_runs=self._confirmer.check_now,
            unsaved_end=self._unsaved_end,
            begin_empty=self._begin_empty,
        )

    def _on_engine_event(self, event: Event) -> None:
        """Handles an event of the engine.

        Records it before publishing, so that the store already has a run's end when the page receives it.
        """
        self._recorder(event)
        if self._legacy is not None:
            self._legacy.observe(event)
        self._hub.publish(event)
        self._camera.observe(event)
        self._overhead.observe(event)
        self._localisation.observe(event)
        self._live_checks.observe(event)
        if event["type"] == "run_ended":
            self._grader.grade(event["run"])

    def _prepare_judge(self, run_id: str, start_info: "RunStartInfo") -> None:
        self._grader.prepare(run_id, start_info)
        self._live_checks.expect(run_id, start_info)

    def _flush_recording(self) -> None:
        with contextlib.suppress(StoreError, TimeoutError):
            self._recorder.flush().result(_FLUSH_TIMEOUT_S)

    def _begin_empty(self) -> None:
        """Removes the record of the missing database folder, so that the next start creates an empty database."""
        forget_location(self._database)
        self._store.notice = StoreNotice("database_begins_empty", {"path": str(self._database)})

    def _unsaved_end(self, run_id: str) -> Mapping[str, Any] | None:
        """Returns the end of a run if it could not be written and the run is still open in the file; else None."""
        if run_id == self._engine.live_run:
            return None
        return self._recorder.unsaved_end(run_id) or (
            _INTERRUPTED if self._store.is_interrupted(run_id) else None
        )

    def _end_recording(self) -> None:
        """Writes pending data, and closes a run that the engine left open."""
        with contextlib.suppress(StoreError):
            self._recorder.flush().result()
            self._store.runs.close_interrupted()
        self._recorder.close()

    def _database_state(self) -> DatabaseState:
        notice = self._recorder.problem or self._store.notice
        writable = self._store.writable and (notice is None or notice.code in WRITABLE_NOTICES)
        notice = notice or self._maintenance.notice or self._content_check.notice
        return DatabaseState(path=str(self._store.path), writable=writable, notice=notice)

    def _publish_recording(self, problem: StoreError | None) -> None:
        """Publishes that the live run cannot be recorded, or is recorded again. The run itself continues."""
        self._publish_notice(problem, "recording_resumed")
        if problem is None:
            self._grader.catch_up()  # runs whose end could not be written until now

    def _publish_storage_notice(self, notice: Problem | None) -> None:
        """Publishes a problem of the storage, or that it is solved. Work continues meanwhile."""
        self._publish_notice(notice, "keeping_well_again")

    def _answer_capture(self, run_id: str, capture: Capture) -> None:
        from pinel_desktop.engine.commands import AnswerCapture  # noqa: PLC0415 - see above

        by, confidence, second = capture.by or "camera", capture.confidence, capture.second
        command = AnswerCapture(result=capture.label, by=by, confidence=confidence, second=second)
        self._engine.command(run_id, command)

    def _publish_camera(self, state: CameraState) -> None:
        problem = state.problem
        text = explain(problem, self._settings.language) if problem else None
        changed = CameraChanged(
            state=state.mode,
            code=problem.code if problem else None,
            params=problem.params if problem else {},
            message=text.message if text else "",
            remedy=text.remedy if text else "",
        )
        self._hub.publish(changed.to_wire())

    def _publish_notice(self, problem: Problem | None, well_again: str) -> None:
        code, params = (problem.code, problem.params) if problem else (well_again, {})
        text = describe(code, params, self._settings.language)
        event = Notice(code=code, message=text.message, remedy=text.remedy, details=text.details)
        self._hub.publish(event.to_wire())


def _warm_up() -> None:
    """Imports the modules for the first edit and the first run, so that these need not wait."""
    from pinel_desktop import worlds  # noqa: F401, PLC0415 - see above
    from pinel_desktop.program import reading  # noqa: F401, PLC0415

    warm_up()
    remove_leftovers()
