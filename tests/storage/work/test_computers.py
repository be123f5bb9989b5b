"""This PC's key and name, also in a data folder that was copied from another PC."""

import shutil
import uuid
from pathlib import Path

import pytest

from storage import GroupRow, ProgramRow, Store, open_store
from storage.work.machine import machine_id_hash


def edited(store: Store, program: ProgramRow, text: str) -> str:
    return store.versions.save(program.id, {"text": text}, None).id


def test_this_pc_has_a_key_that_stays_and_a_name_to_choose(store: Store, path: Path) -> None:
    key, name = store.computers.this()
    assert name
    assert store.computers.rename("PC 07") == "PC 07"
    with open_store(path) as again:
        assert again.computers.this() == (key, "PC 07")


@pytest.mark.parametrize(
    ("node", "name"),
    [("x" * 64, "x" * 60), ("", "PC"), ("\u2800\u3164", "PC"), (" lab-2 ", "lab-2")],
)
def test_whatever_the_network_calls_this_pc_work_is_kept(
    store: Store, program: ProgramRow, monkeypatch: pytest.MonkeyPatch, node: str, name: str
) -> None:
    monkeypatch.setattr("platform.node", lambda: node)
    edited(store, program, "a")
    assert store.computers.this()[1] == name


def test_a_copied_data_folder_is_another_pc_with_its_first_work(
    store: Store,
    path: Path,
    tmp_path: Path,
    group: GroupRow,
    program: ProgramRow,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "one")
    version = edited(store, program, "a")
    key, _ = store.computers.this()
    store.computers.rename("PC 07")
    store.close()
    copy = Path(shutil.copy(path, tmp_path / "copy.db"))
    monkeypatch.setattr("platform.node", lambda: "lab-2")
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "other")
    with open_store(copy) as other:
        assert other.lessons.current(group.classroom_id) is None
        edited(other, program, "b")
        theirs = other.computers.this()
        assert theirs[0] != key
        assert theirs[1] == "lab-2"
        assert other.computers.this() == theirs
        line = other.versions.history_of(program.id)
        assert [(mark.computer, mark.id == version) for mark in line] == [
            ("lab-2", False),
            ("PC 07", True),
        ]
    for mark in ("one", None):
        monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda mark=mark: mark)
        with open_store(path) as again:
            assert again.computers.this() == (key, "PC 07")


def test_two_accounts_of_one_pc_are_two_pcs(tmp_path: Path) -> None:
    keys = set()
    for account in ("José", "María"):
        with open_store(tmp_path / account / "pinel.db") as store:
            keys.add(store.computers.this()[0])
    assert len(keys) == 2


def test_a_file_without_a_machine_s_mark_stays_this_pc_s(
    store: Store, program: ProgramRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: None)
    here = store.computers.this()
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "one")
    assert store.computers.this() == here
    edited(store, program, "a")
    assert store.computers.this() == here
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "other")
    assert store.computers.this() != here


def test_the_mark_of_a_machine_is_the_same_each_time_and_tells_nothing() -> None:
    mark = machine_id_hash()
    machine_id_hash.cache_clear()
    assert machine_id_hash() == mark
    assert mark is None or (len(mark) == 64 and f"{uuid.getnode():012x}" not in mark)
