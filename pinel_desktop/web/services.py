"""What the handlers work with; `app` makes it, handlers ask for it with `services()`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, cast

from flask import current_app

from pinel_desktop.web.guard import Guard

if TYPE_CHECKING:  # heavy, and the page is served without them
    from pinel_desktop.events.hub import Hub
    from pinel_desktop.execution.control import StepMode
    from pinel_desktop.program.faults import Fault
    from pinel_desktop.program.reading import Reading
    from pinel_desktop.teacher import TeacherDoor
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
    ) -> None: ...

    def pause(self, run_id: str) -> None: ...

    def resume(self, run_id: str) -> None: ...

    def stop(self, run_id: str) -> None: ...

    def step(self, run_id: str, mode: StepMode) -> None: ...

    def set_breakpoints(self, run_id: str, blocks: Sequence[str]) -> None: ...

    def set_speed(self, run_id: str, factor: float) -> None: ...

    def look(self, run_id: str, sensors: Sequence[str]) -> None: ...

    def evaluate(self, run_id: str, expression: Any) -> Any: ...

    def answer_capture(self, run_id: str, result: str) -> None: ...

    def answer_question(self, run_id: str, value: str) -> None: ...


class Problem(Protocol):
    """A code and what fills its words: a PinelError, a StoreError or a notice of the store."""

    @property
    def code(self) -> str: ...

    @property
    def params(self) -> dict[str, object]: ...


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
