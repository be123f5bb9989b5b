"""PCs that export and merge, a forger who changes their files, and what counts of it."""

import json
from collections.abc import Iterator
from contextlib import ExitStack, closing
from pathlib import Path
from typing import Any, cast

import pytest

from pinel_desktop.activities import shipped_activity, solution_of
from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.types import RECORDED, URGENT
from pinel_desktop.judge.client import JudgeClient
from pinel_desktop.judge.server import verdict_on
from pinel_desktop.runs.record import record_of
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.runs.start import start
from pinel_desktop.school.confirming import Confirmer
from pinel_desktop.school.grading import Grader
from sim.world import world_document
from storage import RunRecorder, Store, VersionRow, open_store
from storage.exchange.bundle_writing import counts_of
from storage.exchange.content_hash import content_hash
from storage.exchange.merge_report import MergeReport
from storage.exchange.scope import ALL, Scope
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import give_keys_of_before

MISSION = "square"
_IDLE_PROGRAM = {
    "pinel_ir": 1,
    "name": "",
    "functions": [],
    "commands": [{"action": "wait", "seconds": 1}],
}


# the most that a file may claim of a row's state
LATEST_ALLOWED = "revision = 900000, changed_at = '2026-01-01T00:00:00Z'"


class Pc:
    """A PC with a group and its program."""

    def __init__(self, store: Store, folder: Path) -> None:
        self.store, self._folder = store, folder
        self._n_files = 0

    def drives(self, *, well: bool = True, passed: bool | None = None) -> str:
        """A new group drives the mission's solution, or stands still; the run's id. `passed` is what it claims."""
        name = f"Grupo {self._folder.name} {len(self.store.groups.all())}"
        group = self.store.groups.create(name)
        program = self.store.programs.create(group.id, "Quadrado")
        document = solution_of(MISSION) if well else _IDLE_PROGRAM
        version = self.store.versions.save(program.id, {"blocks": {}}, document)
        world = str(shipped_activity(MISSION).world)
        spec = RunSpec(version.document or {}, world_document(world))
        record = record_of(
            spec, world_name=world, app_version="0", version_id=version.id, activity=MISSION
        )
        run = self.store.runs.begin(record)
        stamp, recorder = (
            EventSequencer(run.id),
            RunRecorder(self.store, recorded=RECORDED, urgent=URGENT),
        )
        start(spec, lambda tick, event: recorder(stamp.wire(tick, event)))
        recorder.flush().result()
        recorder.close()
        self.store.grading_results.record(run.id, well if passed is None else passed, {"cases": []})
        return run.id

    def file(self, scope: Scope = ALL) -> Path:
        """What it exports now."""
        self._n_files += 1
        info = self.store.exchange.export(
            self._folder / f"{self._n_files}.pinel",
            app_version="0",
            computer=self.store.computers.this(),
            scope=scope,
        )
        return info.path

    def program_file(self, run_id: str) -> Path:
        """The file of the program of a run, which pupils carry."""
        return self.file(Scope(program_id=self.store.runs.get(run_id).program_id))

    def merges(self, *files: Path) -> MergeReport:
        """The report on the last one."""
        for file in files:
            report = self.store.exchange.merge(file)
        return report

    def counts(self, run_id: str) -> bool:
        """Whether the group of the run has passed the mission here."""
        run = self.store.runs.get(run_id)
        return self.store.grading_results.of_group(run.group_id or "").get(MISSION, False)

    def version(self, run_id: str) -> VersionRow:
        """What the run executed, as it is here."""
        return self.store.versions.get(self.store.runs.get(run_id).version_id or "")

    def forgets_verdict_on(self, run_id: str) -> None:
        """As where the app was closed before the judge answered."""
        query = "UPDATE runs SET passed = NULL, check_report = NULL WHERE id = ?"
        self.store._database.write(lambda db: db.execute(query, [run_id]).rowcount)

    def mark(self, run_id: str) -> str | None:
        """Why the run does not count."""
        return self.store.runs.get(run_id).unconfirmed

    def confirms(self) -> None:
        """Repeats what waits, as the app does while nobody drives; returns when nothing waits."""
        judge = cast("JudgeClient", _JudgeHere())
        grader = Grader(self.store, lambda: None, lambda _event: None, lambda: "en", judge)
        confirmer = Confirmer(self.store, grader.verdict_on)
        try:
            for run_id in self.store.unconfirmed.waiting():
                confirmer.confirm(run_id)
        finally:
            grader.close()


class _JudgeHere:
    """The judge without a process of its own."""

    judge = staticmethod(verdict_on)

    def close(self) -> None:
        pass


def falsified(file: Path, *statements: str, of_before: bool = False) -> Path:
    """The file after somebody changed it, with a checksum that fits; `of_before` as one of a release before 0.3."""
    with closing(sqlite3.connect(file, isolation_level=None)) as db:
        if of_before:
            give_keys_of_before(db)
        for statement in statements:
            assert db.execute(statement).rowcount
        values = [content_hash(db), json.dumps(counts_of(db))]
        db.execute("UPDATE bundle SET content_hash = ?, counts = ?", values)
    return file


def edited(file: Path, statement: str) -> Path:
    """The file after somebody changed it, the checksum left as it was."""
    with closing(sqlite3.connect(file, isolation_level=None)) as db:
        db.execute(statement)
    return file


@pytest.fixture
def pcs(tmp_path: Path) -> Iterator[Any]:
    """PCs by name, each with a data folder of its own."""
    with ExitStack() as stack:
        made: dict[str, Pc] = {}

        def pc(name: str) -> Pc:
            if name not in made:
                store = stack.enter_context(open_store(tmp_path / name / "pinel.db"))
                made[name] = Pc(store, tmp_path / name)
            return made[name]

        yield pc
