"""Writes a finished lesson to a database before the app starts: edits at given times, and runs of the simulator."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any, TypeVar

from pinel_desktop.commands.world_file import choose_world
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Event, RunEnded
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from pinel_desktop.robot import SimulationConfig
from storage import RunRecorder, RunStart, Store, open_for_reading, open_store
from tests.attacks.damage import wait_until
from tests.e2e.app_process import AppProcess

Step = tuple[str, float]
Past = TypeVar("Past")
TICK_S = 1 / 30
_JUDGED_WITHIN_S = 60.0

SQUARE: list[Step] = [("move_forward", 1), ("turn", 90)] * 4


class PastLesson:
    """The work of the groups of a class, on a clock that the test sets."""

    def __init__(self, store: Store, now: datetime) -> None:
        self.store, self.now = store, now
        self.classroom = store.classrooms.create("7º B").id
        self.lesson = store.lessons.open(self.classroom, "Quadrados e desvios", "square").id

    def at(self, minute: float) -> None:
        """Sets the clock to a minute of the lesson, which starts at 0."""
        self.now = STARTED_AT + timedelta(minutes=minute)

    def group(self, name: str) -> "PastGroup":
        return PastGroup(self, name)


STARTED_AT = datetime(2026, 11, 19, 13, 30, tzinfo=UTC)


@contextmanager
def past_lesson(home: Path) -> Iterator[PastLesson]:
    """Opens the database before the app starts."""
    lesson: PastLesson | None = None

    def clock() -> datetime:
        return lesson.now if lesson else STARTED_AT

    with open_store(home / "pinel.db", clock=clock) as store:
        lesson = PastLesson(store, STARTED_AT)
        yield lesson


@contextmanager
def school_after(
    home: Path, play: Callable[[PastLesson], Past]
) -> Iterator[tuple[AppProcess, Past]]:
    """Yields the app on a database with a lesson written by `play`, and the return value of `play`."""
    with past_lesson(home) as lesson:
        past = play(lesson)
    app = AppProcess(home)
    app.start()
    wait_until(lambda: not _waits_for_its_verdict(app.database), _JUDGED_WITHIN_S)
    yield app, past
    app.stop()


def _waits_for_its_verdict(database: Path) -> bool:
    """True while the app has not judged a run of the lesson."""
    with open_for_reading(database) as store:
        return bool(store.grading_results.pending())


class PastGroup:
    """A group and its one program."""

    def __init__(self, lesson: PastLesson, name: str) -> None:
        self._lesson, self._store = lesson, lesson.store
        self.id = self._store.groups.create(name, classroom_id=lesson.classroom).id
        self.program = self._store.programs.create(self.id, "Quadrado da sala").id
        self.version = ""

    def edit(self, *steps: Step, world: Any = None, setup: Any = None) -> str:
        """Saves a version."""
        self.version = self._store.versions.save(
            self.program,
            workspace_of(list(steps)),
            document_of(list(steps)),
            world=world,
            setup=setup,
        ).id
        return self.version

    def run(self, world: str = "empty_room", *, stop_at_s: float | None = None) -> str:
        """Runs the version in the simulator; `stop_at_s` ends the record there, as Stop does."""
        chosen = choose_world(world, robot=SimulationConfig().model)
        document = self._store.versions.get(self.version).document
        started = self._store.runs.begin(
            RunStart(
                link="sim",
                world=world,
                world_document=chosen.document,
                seed=0,
                app_version="0.5",
                version_id=self.version,
                parameters=SimulationConfig().as_parameters(),
            )
        )
        assert document is not None
        program = read_document(document).program
        assert program is not None
        observer = _EventRecorder(self._lesson, started.id, stop_at_s)
        link = open_link("sim", world=chosen.document, setting=SimulationConfig(), seed=0)
        execute(program, link, RunOptions(observer=observer))
        return started.id

    def judged(self, run_id: str, *, passed: bool) -> None:
        self._store.grading_results.record(run_id, passed, {"passed": passed})


class _EventRecorder:
    """Records events and advances the lesson's clock with them."""

    def __init__(self, lesson: PastLesson, run_id: str, stop_at_s: float | None) -> None:
        self._lesson, self._started_at = lesson, lesson.now
        self._record, self._stamp = RunRecorder(lesson.store), EventSequencer(run_id)
        self._stop_tick = None if stop_at_s is None else round(stop_at_s / TICK_S)

    def __call__(self, tick: int, event: Event) -> None:
        if self._stop_tick is not None and tick > self._stop_tick:
            if not isinstance(event, RunEnded):
                return
            tick = self._stop_tick
            event = replace(
                event,
                state="stopped",
                reason="stopped_by_person",
                params={},
                duration_s=tick * TICK_S,
            )
        self._lesson.now = self._started_at + timedelta(seconds=tick * TICK_S)
        self._record(self._stamp.wire(tick, event))


def workspace_of(steps: list[Step]) -> dict[str, Any]:
    """The steps below the start block, in Blockly's serialised form."""
    below: dict[str, Any] | None = None
    for block_id, (kind, value) in reversed(list(zip(_ids(steps), steps, strict=True))):
        block = _block(kind, value, block_id)
        below = {**block, **({"next": {"block": below}} if below else {})}
    start: dict[str, Any] = {"type": "program_start", "id": "start", "x": 40, "y": 40}
    blocks = [{**start, **({"next": {"block": below}} if below else {})}]
    return {"blocks": {"languageVersion": 0, "blocks": blocks}}


def _ids(steps: list[Step]) -> list[str]:
    """Ids of blocks from their type and their index within the type."""
    kinds = [kind for kind, _ in steps]
    return [f"{kind}{kinds[:place].count(kind)}" for place, kind in enumerate(kinds)]


def _block(kind: str, value: float, block_id: str) -> dict[str, Any]:
    name = {"move_forward": "DISTANCE", "turn": "ANGLE", "wait": "SECONDS"}[kind]
    shadow = {"type": "number", "id": f"{block_id}/{name}", "fields": {"NUM": abs(value)}}
    block: dict[str, Any] = {"type": kind, "id": block_id, "inputs": {name: {"shadow": shadow}}}
    if kind == "turn":
        block["fields"] = {"DIRECTION": "RIGHT" if value < 0 else "LEFT"}
    return block


def document_of(steps: list[Step]) -> dict[str, Any]:
    """The program document of the steps."""
    names = {"move_forward": "distance", "turn": "angle", "wait": "seconds"}
    commands = [
        {"action": kind, "block": block_id, names[kind]: value}
        for block_id, (kind, value) in zip(_ids(steps), steps, strict=True)
    ]
    return {"pinel_ir": 1, "name": "", "functions": [], "commands": commands}
