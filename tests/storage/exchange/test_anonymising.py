"""Bundles without names and texts."""

import json
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from storage import RunRecorder, RunStart, Store
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import a_run, exported, merged, problems_in, work
from tests.storage.sample_runs import ended, sample

DOCUMENT = {
    "pinel_ir": 1,
    "name": "Segredo do Joao",
    "functions": [{"name": "danca do Joao", "parameters": ["passos do Joao"], "commands": []}],
    "commands": [
        {"action": "say", "text": "Joao mora aqui", "comment": "Joao", "block": "k1"},
        {"action": "set_variable", "name": "Joao", "value": 3},
        {"action": "move_forward", "distance": {"op": "+", "args": [{"var": "Joao"}, 1]}},
        {"action": "call", "function": "danca do Joao", "arguments": {"passos do Joao": 2}},
        {"action": "pen", "down": True, "color": "red"},
    ],
}
WORLD = {"pinel_world": 1, "name": "own", "title": "Casa do Joao", "floor": [{"color": "green"}]}
FACTS = ("Joao", "Quadrado", "5º B", "Muito bem", "funciona", "Aula da Maria", "Lab 7")


@pytest.fixture
def private(store: Store) -> Store:
    """A store full of what must not leave it."""
    store.computers.rename("Lab 7 da Joao")
    classroom = store.classrooms.create("5º B")
    store.lessons.open(classroom.id, "Aula da Maria")
    group = store.groups.create("Joao e Ana", classroom_id=classroom.id)
    store.groups.change(group.id, {"robot_name": "Carro do Joao", "robot_pattern": "star"})
    program, _ = work(store, group, "Quadrado do Joao")
    version = store.versions.save(program.id, {"text": "Joao"}, DOCUMENT, world=WORLD)
    run = store.runs.begin(RunStart("sim", "own", WORLD, 1, "0.1.0", version_id=version.id))
    recorder = RunRecorder(store)
    recorder(sample(run.id, 0))
    event = {"v": 1, "run": run.id, "tick": 1, "block": "k1"}
    recorder({**event, "type": "said", "seq": 1, "text": "Joao mora aqui"})
    recorder(
        {**event, "type": "watch", "seq": 2, "variables": {"Joao": 3}, "stack": [], "gesture": "B"}
    )
    recorder(ended(run.id, 3, 2))
    store.exchange.purge("run", work(store, group, "Quadrado")[1])
    return store


@pytest.fixture
def anonymous(private: Store, tmp_path: Path) -> Path:
    info = private.exchange.export(
        tmp_path / "x.pinel",
        app_version="0.1.0",
        computer=private.computers.this(),
        anonymous=["empty_room"],
    )
    assert info.anonymous
    return info.path


def rows(path: Path, query: str) -> list[tuple[str, ...]]:
    with closing(sqlite3.connect(path)) as db:
        return db.execute(query).fetchall()


def test_nothing_of_what_was_written_is_in_the_file(private: Store, anonymous: Path) -> None:
    octets = anonymous.read_bytes()
    assert [fact for fact in FACTS if fact.encode() in octets] == []
    assert [fact for fact in FACTS if json.dumps(fact)[1:-1].encode() in octets] == []


def test_a_robot_loses_its_name_and_not_its_pattern(anonymous: Path) -> None:
    assert rows(anonymous, "SELECT robot_name, robot_pattern FROM groups") == [("", "star")]


def test_no_key_of_the_store_is_in_the_file(private: Store, anonymous: Path, path: Path) -> None:
    octets = anonymous.read_bytes()
    for table in ("groups", "classrooms", "programs", "versions", "runs", "lessons", "computers"):
        keys = [key for (key,) in rows(path, f"SELECT id FROM {table}")]
        assert keys
        assert [key for key in keys if key.encode() in octets] == []


@pytest.mark.parametrize("name", ["code", "state", "mode", "color", "reason"])
def test_what_a_variable_is_called_does_not_spare_its_text(
    store: Store, tmp_path: Path, name: str
) -> None:
    program = store.programs.create(store.groups.create("G").id, "P")
    call = {"action": "call", "function": "f", "arguments": {name: "Joao"}}
    version = store.versions.save(program.id, {}, {**DOCUMENT, "commands": [call]})
    run = store.runs.begin(RunStart("sim", "own", WORLD, 1, "0.1.0", version_id=version.id))
    recorder = RunRecorder(store)
    event = {"v": 1, "run": run.id, "tick": 0, "block": None, "type": "watch", "seq": 0}
    recorder({**event, "variables": {name: "Joao"}, "stack": [], "gesture": "Joao"})
    recorder(ended(run.id, 1, 0))
    path = store.exchange.export(
        tmp_path / "x.pinel", app_version="1", computer=("", ""), anonymous=[]
    ).path
    assert b"Joao" not in path.read_bytes()


def test_an_own_world_that_is_called_like_one_that_ships_loses_its_texts(
    store: Store, tmp_path: Path
) -> None:
    shipped = {**WORLD, "name": "empty_room", "title": "Sala vazia"}
    for title in ("Sala vazia", "Casa do Joao"):
        world = {**shipped, "title": title}
        run = store.runs.begin(RunStart("sim", "empty_room", world, 1, "0.1.0", document=DOCUMENT))
        RunRecorder(store)(ended(run.id, 0, 0))
    path = store.exchange.export(
        tmp_path / "x.pinel",
        app_version="1",
        computer=("", ""),
        anonymous=["empty_room", "Sala vazia"],
    ).path
    worlds = [json.loads(text) for (text,) in rows(path, "SELECT world_document FROM runs")]
    assert worlds[0] == shipped
    assert worlds[1]["title"] not in ("Sala vazia", "Casa do Joao")


def test_programs_still_say_what_they_do(anonymous: Path) -> None:
    documents = [json.loads(text) for (text,) in rows(anonymous, "SELECT document FROM versions")]
    found = next(one for one in documents if one["functions"])
    speech, set_variable, move, call, pen = found["commands"]
    assert speech == {"action": "say", "text": speech["text"], "block": speech["block"]}
    assert set_variable["name"] == move["distance"]["args"][0]["var"]
    assert (move["action"], move["distance"]["op"], pen["color"]) == ("move_forward", "+", "red")
    (function,) = found["functions"]
    assert call["function"] == function["name"]
    assert list(call["arguments"]) == function["parameters"]


def test_what_was_driven_stays(private: Store, anonymous: Path, path: Path) -> None:
    blobs = "SELECT data FROM telemetry ORDER BY run_id, chunk"
    assert rows(anonymous, blobs) == rows(path, blobs)
    outcome = "SELECT state, started_at, path_length_m, seed FROM runs ORDER BY id"
    assert rows(anonymous, outcome) == rows(path, outcome)


def test_it_is_a_bundle_as_any_other(
    anonymous: Path, tmp_path: Path, opened: Callable[..., Store]
) -> None:
    other = opened(tmp_path / "other.db")
    report = merged(other, anonymous)
    assert report.added["groups"] == 1
    (group,) = other.groups.all()
    assert (group.name, other.classrooms.all()[0].name) == ("Grupo 1", "Turma 1")
    assert other.lessons.of_classroom(group.classroom_id)[0].title.startswith("Aula ")
    assert report.info.computer_name == "PC"
    assert problems_in(tmp_path / "other.db") == []


def test_two_of_them_cannot_be_joined_by_their_keys(private: Store, tmp_path: Path) -> None:
    keys = []
    for n in range(2):
        info = private.exchange.export(
            tmp_path / f"{n}.pinel", app_version="1", computer=("", ""), anonymous=[]
        )
        keys.append(set(rows(info.path, "SELECT id FROM runs UNION SELECT id FROM groups")))
    assert keys[0].isdisjoint(keys[1])
    assert exported(private, tmp_path / "plain.pinel").content_hash != ""


def test_a_pass_that_is_not_confirmed_is_none_in_it(store: Store, tmp_path: Path) -> None:
    run_id = a_run(store, None)
    marked = "INSERT INTO unconfirmed_runs (run_id, marked_at) VALUES (?, '')"
    passed = "UPDATE runs SET passed = 1, activity = 'square'"
    store._database.write(lambda db: db.execute(marked, [run_id]).rowcount)
    store._database.write(lambda db: db.execute(passed).rowcount)
    info = store.exchange.export(
        tmp_path / "a.pinel",
        app_version="0",
        computer=store.computers.this(),
        anonymous=("square",),
    )
    with closing(sqlite3.connect(info.path)) as db:
        assert db.execute("SELECT count(*) FROM unconfirmed_runs").fetchone() == (0,)
        assert db.execute("SELECT passed FROM runs").fetchone() == (None,)
