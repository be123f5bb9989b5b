"""A lab whose PCs were made from one disk image, with machine id and data folder: each becomes a PC of its own."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from storage import Store, open_store
from storage.file.share_copies import ShareCopies
from storage.sqlite import sqlite3
from storage.work.hardware import Hardware
from tests.storage.bundle_makers import exported, hash_of, merged, removed, work

Switch = Callable[[str], None]


@pytest.fixture
def switch_to(monkeypatch: pytest.MonkeyPatch) -> Switch:
    """Continues on the PC with this network card; all PCs have the machine id of the image."""
    monkeypatch.setattr("storage.work.machine.machine_id_hash", lambda: "of the image")

    def switch(card: str) -> None:
        found: Hardware = {"network": [card], "disk": ["one of a kind"]}
        monkeypatch.setattr("storage.work.machine.hardware_hashes", lambda: found)

    return switch


@pytest.fixture
def image(tmp_path: Path, switch_to: Switch) -> Path:
    """The data folder in the image: PINEL was tried on the PC from which it was made."""
    path = tmp_path / "image" / "pinel.db"
    switch_to("master")
    with open_store(path) as store:
        work(store, store.groups.create("Teste"), "Quadrado")
    return path


def on_pc(image: Path, card: str, switch_to: Switch) -> Store:
    """The store of the PC with this card, made from the image at its first start."""
    switch_to(card)
    folder = image.parents[1] / card
    if not folder.exists():
        shutil.copytree(image.parent, folder)
    return open_store(folder / "pinel.db")


def test_each_pc_has_a_key_of_its_own_before_its_first_work(image: Path, switch_to: Switch) -> None:
    keys, versions = [], []
    for card in ("master", "a", "b"):
        with on_pc(image, card, switch_to) as store:
            (program,) = store.programs.of_group(store.groups.all()[0].id)
            version = store.versions.save(program.id, {"text": card}, None)
            versions.append(version.id)
            keys.append(store.computers.this()[0])
            assert store.versions.history_of(program.id)[0].id == version.id
            with store._database.read_connection() as db:
                row = db.execute("SELECT computer_id FROM versions WHERE id = ?", [version.id])
                assert row.fetchone()[0] == keys[-1]
    assert len(set(keys)) == len(set(versions)) == 3
    for card, key in zip(("master", "a", "b"), keys, strict=True):
        with on_pc(image, card, switch_to) as store:
            assert store.computers.this()[0] == key  # the next start keeps it


def test_merging_two_such_pcs_loses_nothing(image: Path, tmp_path: Path, switch_to: Switch) -> None:
    bundles = []
    for card in ("a", "b"):
        with on_pc(image, card, switch_to) as store:
            store.computers.rename(f"PC {card}")
            group = store.groups.all()[0]
            work(store, group, f"Programa {card}")
            bundles.append(exported(store, tmp_path / f"{card}.pinel").path)
    hashes = set()
    for card, other in (("a", bundles[1]), ("b", bundles[0])):
        with on_pc(image, card, switch_to) as store:
            merged(store, other)
            names = {p.name for p in store.programs.of_group(store.groups.all()[0].id)}
            assert names == {"Quadrado", "Programa a", "Programa b"}
            (known,) = store.exchange.known_computers()
            assert known.name == ("PC b" if card == "a" else "PC a")
            hashes.add(hash_of(store))
    assert len(hashes) == 1


def test_a_deletion_on_one_pc_spares_the_work_of_the_other(
    image: Path, tmp_path: Path, switch_to: Switch
) -> None:
    """With one key for both, the edit would count as known where the program was deleted after a later edit."""
    with on_pc(image, "b", switch_to) as store:
        (program,) = store.programs.of_group(store.groups.all()[0].id)
        version = store.versions.save(program.id, {"text": "b"}, None)
    with on_pc(image, "a", switch_to) as store:
        store.versions.save(program.id, {"text": "a"}, None)
        removed(store, program.id)
        deletion = exported(store, tmp_path / "a.pinel").path
    with on_pc(image, "b", switch_to) as store:
        merged(store, deletion, retain_newer=True)
        assert store.versions.get(version.id).workspace == {"text": "b"}


def test_a_replaced_disk_is_the_same_pc_and_new_hardware_is_stored(
    image: Path, switch_to: Switch, monkeypatch: pytest.MonkeyPatch
) -> None:
    def key_with(hardware: Hardware) -> str:
        monkeypatch.setattr("storage.work.machine.hardware_hashes", lambda: hardware)
        with open_store(image) as store:
            work(store, store.groups.all()[0], f"P {len(store.programs.of_group(group))}")
            return store.computers.this()[0]

    with on_pc(image, "master", switch_to) as store:
        group = store.groups.all()[0].id
    key = key_with({"network": ["master"], "disk": ["new"]})
    assert key_with({"network": ["master", "second"]}) == key
    assert key_with({"network": ["second"]}) == key
    assert key_with({"disk": ["new"]}) == key
    assert key_with({}) == key
    assert key_with({"network": ["third"]}) != key


@pytest.mark.parametrize("stored", ["not json", "[1]", '{"network": 5}', '{"network": [7]}'])
def test_hardware_that_cannot_be_read_fails_nothing(
    stored: str, image: Path, switch_to: Switch
) -> None:
    with sqlite3.connect(image) as db:
        db.execute("UPDATE settings SET value = ? WHERE key = 'hardware_marks'", [stored])
    db.close()
    switch_to("master")
    with open_store(image) as store:
        work(store, store.groups.all()[0], "P")
        assert store.computers.this()[0]


def test_copies_in_the_shared_folder_of_two_such_pcs_are_apart(
    image: Path, tmp_path: Path, switch_to: Switch
) -> None:
    folders = set()
    for card in ("a", "b"):
        with on_pc(image, card, switch_to) as store:
            copies = ShareCopies(store.path, store.computers.this())
            folders.add(copies.folder_in(tmp_path))
    assert len(folders) == 2
