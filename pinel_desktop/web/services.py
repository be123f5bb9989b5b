"""The dependencies of the handlers: `app` constructs them, `services()` returns them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, Protocol, cast

from flask import current_app

from pinel_desktop.messages import Problem
from pinel_desktop.settings import Settings
from pinel_desktop.web.guard import Guard

if TYPE_CHECKING:  # heavy, and not needed to serve the page
    from pinel_desktop.camera.client import CameraClient
    from pinel_desktop.cloud.client import CloudClient
    from pinel_desktop.engine.client import EngineClient
    from pinel_desktop.events.hub import Hub
    from pinel_desktop.judge.messages import RunStartInfo
    from pinel_desktop.program.faults import Fault
    from pinel_desktop.program.reading import ParseResult
    from pinel_desktop.school.detectors import Detectors
    from pinel_desktop.school.opened_file import OpenedFile
    from pinel_desktop.school.predictions import Predictions
    from pinel_desktop.school.robot_profiles import RobotProfiles
    from pinel_desktop.school.robot_status_feed import RobotStatusFeed
    from pinel_desktop.school.sign_teaching import SignTeaching
    from pinel_desktop.school.teacher import TeacherSessions
    from pinel_desktop.school.truths.floor_camera import FloorCamera
    from pinel_desktop.school.truths.localisation import LocalisationTruth
    from pinel_desktop.school.truths.overhead import OverheadTruth
    from storage import Store

# "restart" closes the window and opens it again, in kiosk mode or without it, as the setting says
WindowRequest = Literal["show", "allow_print", "close", "restart"]


class WindowLink(Protocol):
    """The app's window, which is in another process.

    Attributes:
        kiosk: why the window is in kiosk mode: the teacher's setting, or `pinel --kiosk`; None if it is not.
    """

    kiosk: Literal["setting", "command"] | None

    def ask(self, request: WindowRequest) -> None:
        """Sends a request; returns when the window has handled it."""

    def present(self, address: str | None) -> bool:
        """Shows an address on a second screen; None ends that. Returns whether a second screen shows it."""


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
        flush_recording: writes the pending events of the live run; returns when they can be read, or if that fails.
        prepare_judge: sends the start data of a run with an activity to the judge, whose process starts during the run.
        confirm_runs: searches for merged runs that must be re-verified, while no run is live.
        unsaved_end: the `run_ended` event of an ended run while it is not on disk completely; else None.
        begin_empty: makes the next start use an empty database if the known one is unreachable.
        window: the app's window; None if the page is shown by a browser.
    """

    app_version: str
    store: Store
    engine: EngineClient
    camera: CameraClient
    detectors: Detectors
    signs: SignTeaching
    cloud: CloudClient
    overhead: OverheadTruth
    floor_camera: FloorCamera
    localisation: LocalisationTruth
    hub: Hub
    guard: Guard
    settings: Settings
    teacher: TeacherSessions
    robots: RobotProfiles
    status_feed: RobotStatusFeed
    predictions: Predictions
    opened_file: OpenedFile
    worlds: Sequence[dict[str, Any]]
    database_state: Callable[[], DatabaseState]
    window: WindowLink | None
    flush_recording: Callable[[], None]
    prepare_judge: Callable[[str, RunStartInfo], None]
    confirm_runs: Callable[[], None] = lambda: None
    unsaved_end: Callable[[str], Mapping[str, Any] | None] = lambda run_id: None
    begin_empty: Callable[[], None] = lambda: None

    @property
    def is_kiosk(self) -> bool:
        """Whether the window is in kiosk mode."""
        return self.window is not None and self.window.kiosk is not None


def services() -> Services:
    """The services of the app that answers the current request."""
    return cast(Services, current_app.extensions["pinel"])


def read_document(document: dict[str, object] | list[object]) -> ParseResult:
    """Reads a program, as `program.reading.read_document`."""
    from pinel_desktop.program import reading  # noqa: PLC0415 - needed by few requests

    return reading.read_document(document)


def read_world(
    source: Any, *, robot: str | None = None
) -> tuple[dict[str, Any] | None, Sequence[Fault]]:
    """Reads a world, as `worlds.read_own_world`."""
    from pinel_desktop.worlds import read_own_world  # noqa: PLC0415 - needed by few requests

    return read_own_world(source, robot=robot)
