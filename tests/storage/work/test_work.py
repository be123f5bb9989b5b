"""Groups, programs and versions."""

from collections.abc import Callable
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from storage import FaultRow, GroupRow, ProgramRow, Store, StoreError, VersionRow
from storage.sqlite import sqlite3


def test_a_new_file_is_made_with_its_folder(opened: Callable[..., Store], tmp_path: Path) -> None:
    path = tmp_path / "Ação e robôs" / "pinel.db"
    assert opened(path).groups.all() == []
    assert path.is_file()


@pytest.mark.parametrize("same", ["os robôs", "  OS   ROBÔS ", "OsRobôs", "Os\tRobôs"])
def test_a_group_s_name_is_taken_whatever_its_case_and_spaces(
    store: Store, group: GroupRow, same: str
) -> None:
    with pytest.raises(StoreError) as caught:
        store.groups.create(same)
    assert (caught.value.code, caught.value.params["name"]) == ("group_exists", group.name)


@pytest.mark.parametrize(
    ("name", "code"), [("", "name_empty"), (" \n\x00 ", "name_empty"), ("x" * 61, "name_too_long")]
)
def test_a_name_that_does_not_fit_is_refused(store: Store, name: str, code: str) -> None:
    with pytest.raises(StoreError) as caught:
        store.groups.create(name)
    assert caught.value.code == code


@pytest.mark.parametrize(
    "name",
    [
        "\u200b",
        "\u202e",
        "\u00a0\u3000",
        "\u2066\u2069 \u200f",
        "\u200d",
        "\ufeff",
        "\u3164",
        "\u2800",
        "\u00ad",
        "\ufe0f",
        "\ud800",
    ],
    ids=ascii,
)
def test_a_name_that_cannot_be_seen_is_empty(
    store: Store, group: GroupRow, program: ProgramRow, name: str
) -> None:
    attempts: list[Callable[[], object]] = [
        lambda: store.groups.create(name),
        lambda: store.programs.create(group.id, name),
        lambda: store.programs.rename(program.id, name),
    ]
    for attempt in attempts:
        with pytest.raises(StoreError, match="name_empty"):
            attempt()


@pytest.mark.parametrize(
    ("name", "cleaned"),
    [
        ("Zé\u202egpj.exe", "Zégpj.exe"),
        ("\u2067Os\u2069 \u200eRobôs\u200f", "Os Robôs"),
        ("Os\u200b Ro\u00adbôs\x1b", "Os Robôs"),
        ("lone \ud800 half", "lone half"),
        ("\U0001faea", "\U0001faea"),
        ("👩\u200d🔬 ❤\ufe0f", "👩\u200d🔬 ❤\ufe0f"),
    ],
    ids=ascii,
)
def test_a_name_loses_what_turns_or_hides_its_letters(
    store: Store, group: GroupRow, name: str, cleaned: str
) -> None:
    assert store.programs.create(group.id, name).name == cleaned
    assert store.groups.create(f"{name} 2").name == f"{cleaned} 2"


def test_joiners_make_no_second_group_of_the_same_name(store: Store, group: GroupRow) -> None:
    with pytest.raises(StoreError, match="group_exists"):
        store.groups.create("Os Ro\u200dbôs")


def test_a_name_keeps_its_letters_and_loses_what_cannot_be_seen(store: Store) -> None:
    assert store.groups.create("  Zé\x07  da   Silva 🤖 ").name == "Zé da Silva 🤖"


def test_twelve_groups_have_twelve_colors(store: Store) -> None:
    assert len({store.groups.create(f"Grupo {n}").color for n in range(12)}) == 12


def test_the_group_that_was_used_last_comes_first(store: Store) -> None:
    first, second = store.groups.create("A"), store.groups.create("B")
    assert [row.id for row in store.groups.all()] == [second.id, first.id]
    store.programs.create(first.id, "Quadrado")
    assert [row.id for row in store.groups.all()] == [first.id, second.id]


def test_a_program_can_be_renamed_and_two_may_share_a_name(
    store: Store, group: GroupRow, program: ProgramRow
) -> None:
    other = store.programs.create(group.id, program.name)
    store.programs.rename(other.id, "Triângulo")
    assert [row.name for row in store.programs.of_group(group.id)] == ["Triângulo", "Quadrado"]


def test_what_does_not_exist_is_named(store: Store) -> None:
    attempts: dict[str, Callable[[], object]] = {
        "group_not_found": lambda: store.programs.create("nobody", "x"),
        "program_not_found": lambda: store.versions.save("nothing", {}, None),
        "version_not_found": lambda: store.versions.get("nothing"),
        "run_not_found": lambda: store.runs.telemetry("nothing"),
    }
    for code, attempt in attempts.items():
        with pytest.raises(StoreError) as caught:
            attempt()
        assert caught.value.code == code


def test_every_save_is_a_version_and_none_is_overwritten(store: Store, program: ProgramRow) -> None:
    saved = [store.versions.save(program.id, {"n": n}, None) for n in range(3)]
    assert [store.versions.get(version.id).workspace for version in saved] == [
        {"n": 0},
        {"n": 1},
        {"n": 2},
    ]
    assert store.programs.get(program.id).n_versions == 3


def test_the_same_content_as_the_newest_version_is_that_version(
    store: Store, program: ProgramRow, version: VersionRow
) -> None:
    again = store.versions.save(program.id, version.workspace, version.document)
    assert again.id == version.id
    other = store.versions.save(program.id, {"blocks": {"x": 1}}, version.document)
    back = store.versions.save(program.id, version.workspace, version.document)
    assert len({version.id, other.id, back.id}) == 3


def test_a_version_may_hold_a_world_which_is_part_of_its_content(
    store: Store, program: ProgramRow, version: VersionRow
) -> None:
    assert version.world is None
    world = {"pinel_world": 1, "name": "own", "title": "A nossa sala é grande"}
    own = store.versions.save(program.id, version.workspace, version.document, world=world)
    assert own.id != version.id
    assert store.versions.get(own.id).world == world
    again = store.versions.save(program.id, version.workspace, version.document, world=dict(world))
    assert again.id == own.id


def test_a_version_with_faults_keeps_the_blocks_and_the_faults(
    store: Store, program: ProgramRow
) -> None:
    fault = FaultRow("distance_out_of_range", "/commands/0/distance", "kL0p", {"value": -1})
    saved = store.versions.save(program.id, {"blocks": {}}, None, [fault])
    assert store.versions.newest(program.id) == saved
    assert (saved.document, saved.faults) == (None, (fault,))


def test_the_newest_version_is_the_last_saved_even_when_the_clock_was_set_back(
    opened: Callable[..., Store], path: Path
) -> None:
    now = [datetime(2026, 11, 21, 12, tzinfo=UTC)]
    store = opened(path, clock=lambda: now[0])
    program = store.programs.create(store.groups.create("A").id, "P")
    store.versions.save(program.id, {"n": 1}, None)
    now[0] -= timedelta(days=3000)
    store.versions.save(program.id, {"n": 2}, None)
    newest = store.versions.newest(program.id)
    assert newest is not None
    assert newest.workspace == {"n": 2}


def test_texts_that_no_encoding_holds_are_kept(store: Store, program: ProgramRow) -> None:
    workspace: dict[str, Any] = {"text": "lone \ud800 surrogate", "nul": "\x00"}
    assert store.versions.save(program.id, workspace, None).workspace == workspace


def test_what_no_bundle_could_carry_is_refused_and_not_kept(
    store: Store, program: ProgramRow
) -> None:
    """Blocks may lie deep in each other; nothing else that is saved with them does."""
    deep: dict[str, Any] = {}
    for _ in range(500):
        deep = {"do": deep}
    saved = store.versions.save(program.id, deep, None)
    assert store.versions.get(saved.id) == saved
    with pytest.raises(StoreError, match="work_unreadable"):
        store.versions.save(program.id, {}, deep)
    assert [mark.id for mark in store.versions.history_of(program.id)] == [saved.id]


def test_settings_are_kept(store: Store, opened: Callable[..., Store]) -> None:
    assert store.settings.get("language") is None
    store.settings.set("language", "es")
    store.settings.set("language", "en")
    assert opened().settings.get("language") == "en"


def test_the_file_explains_itself(store: Store, version: VersionRow, path: Path) -> None:
    with sqlite3.connect(path) as db:
        tables = {
            row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type = 'table'")
        }
        named = {
            name for row in db.execute("SELECT name FROM about") for name in row[0].split(", ")
        }
        assert db.execute('SELECT "group", program, versions FROM program_list').fetchall() == [
            ("Os Robôs", "Quadrado", 1)
        ]
        views = {row[0] for row in db.execute("SELECT name FROM sqlite_master WHERE type = 'view'")}
    db.close()
    assert named == (tables | views) - {"_sqlite_migrations", "about"}


def test_where_and_how_it_runs_is_part_of_a_version(
    store: Store, program: ProgramRow, version: VersionRow
) -> None:
    assert version.setup is None
    setup = {"world": "maze", "speed": 2}
    content = (program.id, version.workspace, version.document)
    in_the_maze = store.versions.save(*content, setup=setup)
    assert in_the_maze.id != version.id
    assert store.versions.get(in_the_maze.id).setup == setup
    assert store.versions.save(*content, setup=dict(setup)).id == in_the_maze.id
    newest, before = store.versions.history_of(program.id)[:2]
    assert (newest.setup, before.setup) == (setup, None)
