"""The dependencies of the handlers: `app` constructs them, `services()` returns them."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, cast

from flask import current_app

from pinel_desktop.messages import Problem
from pinel_desktop.page_settings import PageSettings
from pinel_desktop.web.guard import Guard

if TYPE_CHECKING:  # heavy, and not needed to serve the page
    from pinel_desktop.engine.commands import Command
    from pinel_desktop.errors import PinelError
    from pinel_desktop.events.hub import Hub
    from pinel_desktop.program.faults import Fault
    from pinel_desktop.program.reading import Reading
    from pinel_desktop.robot.record import RobotRecord
    from pinel_desktop.runs.spec import RunSpec
    from pinel_desktop.school.robot_watching import RobotWatching
    from pinel_desktop.school.robots import Robots
    from pinel_desktop.school.teacher import TeacherSessions
    from storage import Store

ReadDocument = Callable[[dict[str, object] | list[object]], "Reading"]


class ReadWorld(Protocol):
    """Reads a world document: its normal form, or None and its faults."""

    def __call__(
        self, source: Any, *, robot: str | None = None
    ) -> tuple[dict[str, Any] | None, Sequence[Fault]]:
        """
        Args:
            robot: name of the model that must fit at the start pose; None is the largest.
        """
        ...


class Engine(Protocol):
    """The part of `engine.client.EngineClient` that handlers use."""

    @property
    def state(self) -> Literal["starting", "ready", "lost"]: ...

    @property
    def live_run(self) -> str | None: ...

    def run(self, run_id: str, spec: RunSpec, commands: Sequence[Command] = ()) -> None: ...

    def command(self, run_id: str, command: Command) -> Any: ...

    def contact(self, robot: RobotRecord) -> dict[str, Any]: ...

    def find(self, robot: RobotRecord) -> list[dict[str, Any]]: ...

    def watch(self, robot: RobotRecord) -> None: ...

    def jog(self, robot: RobotRecord, drive: float, turn: float, sent_s: float) -> None: ...

    def halt(self, robot: RobotRecord) -> None: ...

    def stand_at_start(self, robot: RobotRecord) -> None: ...


class CameraState(Protocol):
    """What the camera does, and why it is of no use."""

    @property
    def mode(self) -> Literal["off", "opening", "on", "failed"]: ...

    @property
    def problem(self) -> PinelError | None: ...


class Camera(Protocol):
    """What the handlers need of `camera.client.Camera`."""

    @property
    def state(self) -> CameraState: ...

    @property
    def source(self) -> str: ...

    def wake(self) -> None: ...

    def choose(self, source: str) -> None: ...

    def previews(self, *, annotated: bool = False) -> Generator[bytes]: ...

    def caption(self, text: str) -> None: ...


class KnownSign(Protocol):
    """A sign that captures can answer."""

    @property
    def name(self) -> str: ...

    @property
    def is_letter(self) -> bool: ...

    @property
    def n_samples(self) -> int: ...

    @property
    def n_movements(self) -> int: ...

    @property
    def landmarks(self) -> list[list[float]] | None: ...


class Signs(Protocol):
    """What the handlers need of `school.sign_teaching.SignTeaching`."""

    def signs(self, classroom_id: str | None) -> Sequence[KnownSign]: ...

    def use(self, classroom_id: str | None) -> None: ...

    def refresh(self) -> None: ...

    def record(self, classroom_id: str, name: str, *, is_moving: bool = False) -> str: ...

    def stop(self) -> None: ...

    def forget(self, classroom_id: str, name: str) -> None: ...


class Preferences(Protocol):
    """Choices of the person; persistent if the database is writable.

    Attributes:
        page: what the page keeps.
    """

    language: str
    camera: str
    page: PageSettings


@dataclass(frozen=True, slots=True)
class DatabaseState:
    """The path of the database, whether it can be written, and a message about it for people."""

    path: str
    writable: bool
    notice: Problem | None


@dataclass(frozen=True, slots=True)
class Services:
    """All dependencies of the handlers.

    Attributes:
        flush_recording: writes the pending events of the live run; returns once they can be read, or if that fails.
        prepare_judge: starts the process that judges runs of activities, before the first one ends.
        confirm_runs: looks for runs that came with a file and are to be repeated, when nobody drives.
        unsaved_end: the `run_ended` event of a run that is over, as far as it is not on disk; else None.
        begin_empty: lets the next start begin with an empty database where the known one is away.
        show_window: brings the window forward; does nothing without a window.
    """

    app_version: str
    store: Store
    engine: Engine
    camera: Camera
    signs: Signs
    hub: Hub
    guard: Guard
    preferences: Preferences
    teacher: TeacherSessions
    robots: Robots
    robot_watching: RobotWatching
    read_document: ReadDocument
    read_world: ReadWorld
    worlds: Sequence[dict[str, Any]]
    database_state: Callable[[], DatabaseState]
    show_window: Callable[[], None]
    flush_recording: Callable[[], None]
    prepare_judge: Callable[[], None]
    confirm_runs: Callable[[], None] = lambda: None
    unsaved_end: Callable[[str], Mapping[str, Any] | None] = lambda run_id: None
    begin_empty: Callable[[], None] = lambda: None


def services() -> Services:
    """The services of the app that answers the current request."""
    return cast(Services, current_app.extensions["pinel"])
