"""What the handlers work with; `app` makes it, handlers ask for it with `services()`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, cast

from flask import current_app

from pinel_desktop.messages import Problem
from pinel_desktop.web.guard import Guard

if TYPE_CHECKING:  # heavy, and the page is served without them
    from pinel_desktop.engine.commands import Command
    from pinel_desktop.events.hub import Hub
    from pinel_desktop.program.faults import Fault
    from pinel_desktop.program.reading import Reading
    from pinel_desktop.runs.spec import RunSpec
    from pinel_desktop.school.teacher import TeacherDoor
    from storage import Store

ReadDocument = Callable[[dict[str, object] | list[object]], "Reading"]


class ReadWorld(Protocol):
    """Reads a world document: its normal form, or None and its faults."""

    def __call__(
        self, source: Any, *, robot: str | None = None
    ) -> tuple[dict[str, Any] | None, Sequence[Fault]]:
        """
        Args:
            robot: which one must have room at the start; the largest when not told.
        """
        ...


class Engine(Protocol):
    """What the handlers need of `engine.client.EngineClient`."""

    @property
    def state(self) -> Literal["starting", "ready", "lost"]: ...

    @property
    def live_run(self) -> str | None: ...

    def run(self, run_id: str, spec: RunSpec, commands: Sequence[Command] = ()) -> None: ...

    def command(self, run_id: str, command: Command) -> Any: ...


class Preferences(Protocol):
    """What a person chose; it outlives the app where the database can be written."""

    language: str


@dataclass(frozen=True, slots=True)
class DatabaseState:
    """Where the work is kept, whether it is, and what a person should know about that."""

    path: str
    writable: bool
    notice: Problem | None


@dataclass(frozen=True, slots=True)
class Services:
    """Everything the handlers may touch.

    Attributes:
        keep_up: writes what the live run has done so far; returns when it can be read, or cannot be written.
        show_window: brings the window forward; does nothing where there is none.
    """

    app_version: str
    store: Store
    engine: Engine
    hub: Hub
    guard: Guard
    preferences: Preferences
    teacher: TeacherDoor
    read_document: ReadDocument
    read_world: ReadWorld
    worlds: Sequence[dict[str, Any]]
    database_state: Callable[[], DatabaseState]
    show_window: Callable[[], None]
    keep_up: Callable[[], None]


def services() -> Services:
    """The services of the app that answers the current request."""
    return cast(Services, current_app.extensions["pinel"])
