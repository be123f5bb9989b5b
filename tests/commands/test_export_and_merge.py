"""`pinel export` and `pinel merge` on the command line."""

import json
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main
from storage import open_store
from storage.exchange.scope import Scope
from storage.sqlite import sqlite3
from tests.storage.bundle_makers import a_run, exported, work

PROGRAMS = Path(__file__).parents[1] / "programs"


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PINEL_LANG", "en")


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    """The database of a PC of the lab on which two groups have worked."""
    path = tmp_path / "lab.db"
    with open_store(path) as store:
        store.computers.rename("Lab 7")
        classroom = store.classrooms.create("5º B")
        for name in ("Onças", "Araras"):
            group = store.groups.create(name, classroom_id=classroom.id)
            work(store, group, f"Quadrado das {name}")
    return path


@pytest.fixture
def stick(tmp_path: Path) -> Path:
    folder = tmp_path / "stick"
    folder.mkdir()
    return folder


@pytest.fixture
def teacher(tmp_path: Path) -> Path:
    return tmp_path / "teacher" / "pinel.db"


def pinel(*arguments: object) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


def answer(*arguments: object) -> dict[str, Any]:
    done = pinel(*arguments, "--json")
    assert done.exit_code == 0, done.output
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def test_a_folder_gets_a_file_named_after_the_pc(lab: Path, stick: Path) -> None:
    done = pinel("export", stick, "--db", lab)
    assert done.exit_code == 0
    (file,) = stick.iterdir()
    assert file.name.startswith("Lab-7-")
    assert file.suffix == ".pinel"
    assert "Groups: 2; programs: 2; runs: 2." in done.stdout


def test_what_other_pcs_would_refuse_is_counted_and_not_lost(lab: Path, stick: Path) -> None:
    with closing(sqlite3.connect(lab)) as db, db:
        db.execute("UPDATE groups SET changed_at = '9999-12-31T00:00:00Z' WHERE name = 'Onças'")
    done = pinel("export", stick, "--db", lab)
    assert "Groups: 1;" in done.stdout
    assert "Parts of the work left out of the file" in done.stderr
    assert "Onças / " in done.stderr
    assert "pinel export --json" in done.stderr
    left_out = answer("export", stick, "--db", lab)["left_out"]
    assert any(row.startswith("groups.changed_at ") for row in left_out)
    with open_store(lab) as store:
        assert len(store.groups.all()) == 2


def test_what_was_exported_comes_in_once(lab: Path, stick: Path, teacher: Path) -> None:
    exported = answer("export", stick, "--db", lab)
    first = answer("merge", exported["path"], "--db", teacher)
    assert first["added"]["runs"] == 2
    assert first["content_hash"] == exported["content_hash"]
    (file,) = first["files"]
    assert (file["computer_name"], file["nothing_new"]) == ("Lab 7", False)
    second = answer("merge", exported["path"], "--db", teacher)
    assert second["added"] == {}
    assert second["files"][0]["nothing_new"]
    assert second["content_hash"] == first["content_hash"]


def test_whoever_merges_has_the_same_hash(lab: Path, stick: Path, tmp_path: Path) -> None:
    answer("export", stick, "--db", lab)
    with open_store(tmp_path / "other.db") as store:
        a_run(store, None)
    answer("export", stick / "other", "--db", tmp_path / "other.db")
    files = sorted(stick.iterdir())
    hashes = {
        answer("merge", *order, "--db", tmp_path / f"{n}.db")["content_hash"]
        for n, order in enumerate([files, files[::-1], [stick], [*files, *files]])
    }
    assert len(hashes) == 1


def test_in_words(lab: Path, stick: Path, teacher: Path) -> None:
    pinel("export", stick / "a", "--db", lab)
    done = pinel("merge", stick, "--db", teacher)
    assert (
        "a.pinel, from Lab 7. Added: groups, 2; programs, 2; versions, 4; runs, 2." in done.stdout
    )
    assert done.stdout.splitlines()[-1].startswith("content_hash  ")
    assert "nothing new" in pinel("merge", stick, "--db", teacher).stdout


def test_what_another_pc_has_deleted_goes_only_when_that_is_asked_for(
    lab: Path, stick: Path, teacher: Path
) -> None:
    answer("export", stick, "--db", lab)
    answer("merge", stick, "--db", teacher)
    with open_store(lab) as store:
        store.exchange.purge("classroom", store.classrooms.all()[0].id)
    path = answer("export", stick, "--db", lab)["path"]
    done = pinel("merge", path, "--db", teacher)
    assert done.exit_code == 0
    assert "what is here still (5º B, Araras, Onças" in done.stdout
    assert "Groups: 2; programs: 2; runs: 2." in done.stdout
    assert "--delete" in done.stdout
    (file,) = answer("merge", path, "--db", teacher)["files"]
    assert (file["removed"], file["would_delete"]["groups"]) == ({}, 2)
    (file,) = answer("merge", path, "--db", teacher, "--delete")["files"]
    assert (file["removed"]["groups"], file["would_delete"]) == (2, None)
    with open_store(teacher) as store:
        assert store.classrooms.all() == []


@pytest.mark.parametrize(
    ("option", "name", "runs"), [("--group", "onças", 1), ("--class", "5º b", 2)]
)
def test_a_part_is_chosen_by_name(
    lab: Path, stick: Path, option: str, name: str, runs: int
) -> None:
    exported = answer("export", stick / "part.pinel", "--db", lab, option, name)
    assert exported["counts"]["runs"] == runs


def test_a_program_goes_on_on_another_pc(lab: Path, stick: Path, teacher: Path) -> None:
    exported = answer("export", stick, "--db", lab, "--program", "Quadrado das Araras")
    assert exported["counts"]["programs"] == 1
    assert answer("merge", stick, "--db", teacher)["added"]["versions"] == 2


def test_runs_as_they_are_really_recorded_pass_all_that_a_bundle_is_held_against(
    tmp_path: Path, stick: Path, teacher: Path
) -> None:
    lab = tmp_path / "real.db"
    for name in ("tic_tac_toe", "classroom", "b_or_a_not_recognised"):
        pinel("run", PROGRAMS / f"{name}.json", "--db", lab, "--preset", "realistic")
    pinel("run", PROGRAMS / "square.json", "--db", lab, "--gestures", "B,A")
    answer("export", stick, "--db", lab)
    assert answer("merge", stick, "--db", teacher)["added"]["runs"] == 4
    answer("export", stick, "--db", lab, "--anonymous")
    assert answer("merge", stick, "--db", teacher)["added"]["runs"] == 4


def test_a_district_gets_parquet(lab: Path, stick: Path) -> None:
    folder = Path(answer("export", stick, "--db", lab, "--parquet")["path"])
    assert folder.parent == stick
    assert (folder / "runs.parquet").stat().st_size > 0


def test_only_one_part_can_be_chosen(lab: Path, stick: Path) -> None:
    assert pinel("export", stick, "--db", lab, "--group", "a", "--class", "b").exit_code == 2


def test_names_can_be_left_out(lab: Path, stick: Path, teacher: Path) -> None:
    exported = answer("export", stick, "--db", lab, "--anonymous")
    octets = Path(exported["path"]).read_bytes()
    assert [name for name in ("Onças", "Araras", "Lab 7", "5º B") if name.encode() in octets] == []
    assert Path(exported["path"]).name.startswith("PINEL-no-names-")
    assert "Added: groups, 2;" in (output := pinel("merge", stick, "--db", teacher).stdout)
    assert "without names" in output
    assert "without names" not in pinel("merge", stick, "--db", teacher).stdout


def test_a_name_that_nobody_has_is_told_with_those_that_there_are(lab: Path, stick: Path) -> None:
    done = pinel("export", stick, "--db", lab, "--group", "Zebras")
    assert done.exit_code == 1
    assert "Zebras" in done.stderr
    assert "Araras" in done.stderr
    assert list(stick.iterdir()) == []


def test_what_cannot_be_used_is_refused_and_the_rest_merged(
    lab: Path, stick: Path, teacher: Path
) -> None:
    answer("export", stick, "--db", lab)
    (stick / "a.pinel").write_bytes(b"")
    (stick / "b.pinel").write_text("a letter", "utf-8")
    done = pinel("merge", stick, stick / "missing.pinel", lab, "--db", teacher, "--json")
    assert done.exit_code == 2
    found = json.loads(done.stdout)
    assert found["added"]["runs"] == 2
    codes = [file["error"] and file["error"]["code"] for file in found["files"]]
    assert sorted(filter(None, codes)) == sorted(
        ["bundle_damaged", "bundle_foreign", "bundle_missing", "bundle_is_store"]
    )


def test_an_empty_folder_is_told(stick: Path, teacher: Path) -> None:
    done = pinel("merge", stick, "--db", teacher)
    assert done.exit_code == 2
    assert "holds no exported files" in done.stdout


def test_without_a_database_there_is_nothing_to_export(tmp_path: Path, stick: Path) -> None:
    done = pinel("export", stick, "--db", tmp_path / "none.db")
    assert done.exit_code == 1
    assert not (tmp_path / "none.db").exists()


def test_a_damaged_database_is_left_where_it_is(lab: Path, stick: Path) -> None:
    lab.write_bytes(lab.read_bytes()[:5000])
    before = lab.read_bytes()
    for arguments in (("export", stick), ("merge", stick)):
        assert pinel(*arguments, "--db", lab).exit_code == 1
    assert lab.read_bytes() == before


def test_another_program_that_writes_all_the_time_is_told(
    lab: Path, stick: Path, teacher: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer("export", stick, "--db", lab)
    monkeypatch.setattr("storage.file.opening._BUSY_S", 0.05)
    pinel("merge", stick / "none", "--db", teacher)
    with closing(sqlite3.connect(teacher)) as other:
        other.execute("BEGIN IMMEDIATE")
        done = pinel("merge", stick, "--db", teacher)
    assert done.exit_code in (1, 2)
    assert "another" in done.output.lower()


def test_it_works_beside_an_open_app(lab: Path, stick: Path, teacher: Path) -> None:
    answer("export", stick, "--db", lab)
    with open_store(teacher) as app:
        assert answer("merge", stick, "--db", teacher)["added"]["runs"] == 2
        assert len(app.groups.all()) == 2


def test_a_lesson_file_opens_its_lesson_when_that_is_asked_for(
    lab: Path, stick: Path, teacher: Path
) -> None:
    with open_store(lab) as store:
        classroom = store.classrooms.all()[0].id
        lesson = store.lessons.open(classroom, "Quadrados")
        scope = Scope(classroom_id=classroom, lesson_id=lesson.id)
        path = exported(store, stick / "lesson.pinel", scope).path
    assert "is open" not in pinel("merge", path, "--db", teacher).stdout
    done = pinel("merge", path, "--db", teacher, "--open-lesson")
    assert "The lesson “Quadrados” is open on this PC." in done.stdout
    with open_store(teacher) as store:
        current = store.lessons.current(classroom)
    assert current is not None
    assert current.id == lesson.id
