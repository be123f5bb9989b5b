"""Stores on real files; an unclosed store fails the test with a ResourceWarning."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from storage import GroupRow, ProgramRow, RunStart, Store, VersionRow, open_store
from storage.limits import N_FEATURES
from storage.sqlite import sqlite3
from storage.tables.ddl import MIGRATIONS
from storage.tables.migrations import migrate
from tests.storage.bundle_makers import Opened, a_run, a_store, exported, work
from tests.storage.sample_documents import SQUARE, WORLD


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "pinel.db"


@pytest.fixture
def opened(path: Path) -> Iterator[Callable[..., Store]]:
    """Opens stores and closes them at the end of the test."""
    with ExitStack() as stack:
        yield lambda file=path, **options: stack.enter_context(open_store(file, **options))


@pytest.fixture
def store(opened: Callable[..., Store]) -> Store:
    return opened()


@pytest.fixture
def group(store: Store) -> GroupRow:
    return store.groups.create("Os Robôs")


@pytest.fixture
def program(store: Store, group: GroupRow) -> ProgramRow:
    return store.programs.create(group.id, "Quadrado")


@pytest.fixture
def version(store: Store, program: ProgramRow) -> VersionRow:
    return store.versions.save(program.id, {"blocks": {}}, SQUARE)


@pytest.fixture
def start(version: VersionRow) -> RunStart:
    return RunStart(
        link="sim",
        world="empty_room",
        world_document=WORLD,
        seed=7,
        app_version="0.1.0",
        version_id=version.id,
    )


@pytest.fixture
def older(path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A database with a group, of a release that had not yet the newest migration."""
    with sqlite3.connect(path) as db:
        migrate(db)
        db.execute(
            """INSERT INTO groups (id, name, name_key, color, created_at, used_at)
               VALUES ('g', 'A', 'a', '#000000', 't', 't')"""
        )
    db.close()
    monkeypatch.setitem(MIGRATIONS, "newest", ("CREATE INDEX newest ON groups (color)",))
    return path


@pytest.fixture(scope="module")
def original(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A bundle with rows of every kind."""
    folder = tmp_path_factory.mktemp("there")
    with open_store(folder / "there.db") as there:
        classroom = there.classrooms.create("5º B")
        there.lessons.open(classroom.id, "Quadrados")
        there.taught_signs.add(classroom.id, "7", bytes(2 * N_FEATURES))
        activity = {"pinel_activity": 2, "name": "a", "title": {}, "checks": [], "cases": []}
        goal: dict[str, object] = {"lines": [], "zones": [], "boxes": {}}
        there.own_activities.save(there.own_activities.new_key(), "Até a porta", activity, goal)
        there.calibrated_robots.create("Pioneer", "pioneer_3dx", {"track_m": 0.34}, {})
        there.class_presets.set(classroom.id, {"level": 2})
        work(there, there.groups.create("Onças", classroom_id=classroom.id), "Quadrado")
        a_run(there, None)
        return exported(there, folder / "there.pinel").path


@pytest.fixture
def bundle(original: Path, tmp_path: Path) -> Path:
    """A copy of `original` that the test may change."""
    return shutil.copyfile(original, tmp_path / original.name)


@pytest.fixture
def pc(tmp_path: Path) -> Iterator[Opened]:
    """Stores of PCs by name; each is closed at the end."""
    with ExitStack() as stack:
        yield lambda name: stack.enter_context(a_store(tmp_path / f"{name}.db"))


# a class, its group and its program, in the fixture `school` of the test file


@pytest.fixture
def ninth(school: Store) -> str:
    return school.classrooms.create("9º A").id


@pytest.fixture
def robots(school: Store, ninth: str) -> GroupRow:
    return school.groups.create("Os Robôs", classroom_id=ninth)


@pytest.fixture
def square(school: Store, robots: GroupRow) -> ProgramRow:
    return school.programs.create(robots.id, "Quadrado")
