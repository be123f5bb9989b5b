"""The PC's key: where it lies, when it is made anew, and what is signed with it."""

import json
import stat
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path

import pytest

from storage import Store
from storage.exchange.bundle_reading import open_bundle
from storage.exchange.signing import fingerprint, key_path, own_public_key
from storage.file.backups import make_backup
from storage.sql import opened as connected
from tests.storage.bundle_makers import Opened, a_run, exported, merged

WRONG = ("differs", "not_passed")  # what was found when the run was repeated here


def key_of(store: Store) -> str | None:
    return own_public_key(store.path, store.computers.this()[0])


def test_a_file_names_the_key_of_the_pc_that_signed_it(pc: Opened, tmp_path: Path) -> None:
    info = exported(pc("a"), tmp_path / "a.pinel")
    with open_bundle(info.path) as bundle:
        assert bundle.info.signed_by == info.signed_by == key_of(pc("a")) is not None
    assert info.signed_by != key_of(pc("b"))


def test_only_the_owner_reads_the_key_and_it_is_in_no_database_backup_or_bundle(
    store: Store, tmp_path: Path
) -> None:
    info = exported(store, tmp_path / "a.pinel")
    path = key_path(store.path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    seed = bytes.fromhex(json.loads(path.read_text("utf-8"))["seed"])
    backup = make_backup(store.path, datetime.now(UTC))
    assert backup is not None
    for file in (store.path, info.path, backup.path):
        assert seed not in file.read_bytes()
        assert seed.hex().encode() not in file.read_bytes()


def test_a_lost_or_damaged_key_is_made_anew_and_another_pc_s_is_not_used(store: Store) -> None:
    keys = [key_of(store)]
    assert key_of(store) == keys[0]
    key_path(store.path).write_text("no key")
    keys.append(key_of(store))
    key_path(store.path).unlink()
    keys.append(key_of(store))
    kept = json.loads(key_path(store.path).read_text("utf-8"))
    key_path(store.path).write_text(json.dumps(kept | {"computer_id": "another"}))
    keys.append(key_of(store))  # the folder was copied
    assert len(set(keys)) == 4
    assert None not in keys


def test_a_pc_that_cannot_keep_a_key_writes_files_without_signature(
    store: Store, tmp_path: Path
) -> None:
    key_path(
        store.path
    ).mkdir()  # in place of a folder that takes no file: root may write everywhere
    info = exported(store, tmp_path / "a.pinel")
    assert info.signed_by is None
    with open_bundle(info.path) as bundle:
        assert bundle.info.signed_by is None


def test_no_key_tells_the_pc_in_a_file_without_names(store: Store, tmp_path: Path) -> None:
    version = store.versions.save(
        store.programs.create(store.groups.create("A").id, "P").id, {}, {"pinel_ir": 1}
    )
    run_id = a_run(store, version.id)
    mark = "INSERT INTO unconfirmed_runs (run_id, marked_at) VALUES (?, '')"
    passed = "UPDATE runs SET passed = 1, activity = 'square'"
    store._database.write(lambda db: db.execute(mark, [run_id]).rowcount)
    store._database.write(lambda db: db.execute(passed).rowcount)
    info = store.exchange.export(
        tmp_path / "a.pinel",
        app_version="0",
        computer=store.computers.this(),
        anonymous=("square",),
    )
    with closing(connected(info.path, "ro")) as db:
        assert db.execute("SELECT count(*) FROM signatures").fetchone() == (0,)
        assert db.execute("SELECT count(*) FROM unconfirmed_runs").fetchone() == (0,)
        assert db.execute("SELECT passed FROM runs").fetchone() == (None,)


def test_approving_a_pc_leaves_the_marks_of_runs_that_came_out_otherwise(store: Store) -> None:
    key = "0" * 64
    found = {a_run(store, None): finding for finding in (None, "not_repeatable", *WRONG)}
    known = "INSERT INTO computer_keys VALUES (?, ?, 'PC', '', NULL)"
    marked = "INSERT INTO unconfirmed_runs VALUES (?, ?, '', ?)"
    store._database.write(lambda db: db.execute(known, [key, next(iter(found))]).rowcount)
    rows = [(run_id, key, finding) for run_id, finding in found.items()]
    store._database.write(lambda db: db.executemany(marked, rows).rowcount)
    store.computer_keys.approve(key)
    assert {found[run_id]: store.runs.get(run_id).unconfirmed for run_id in found} == {
        None: None,
        "not_repeatable": None,
        "differs": "differs",
        "not_passed": "not_passed",
    }


@pytest.mark.parametrize(
    "change",
    [
        "UPDATE bundle SET exported_at = '2026-01-01T00:00:00Z'",
        "UPDATE bundle SET app_version = '9'",
        "PRAGMA application_id = 1347308609",
        "INSERT INTO unconfirmed_runs (run_id, marked_at) SELECT id, '' FROM runs",
        "UPDATE signatures SET signature = '00' || substr(signature, 3)",
        "UPDATE signatures SET public_key = '00' || substr(public_key, 3)",
        "UPDATE signatures SET signature = 'x'",
        "INSERT INTO signatures SELECT substr(public_key, 3) || '00', signature FROM signatures",
    ],
)
def test_whatever_a_signature_covers_cannot_be_changed(
    bundle: Path, store: Store, change: str
) -> None:
    with closing(connected(bundle, "rw")) as db:
        db.execute(change)
    with pytest.raises(Exception, match="bundle_damaged"):
        merged(store, bundle)


def test_codes_are_short_and_of_letters_that_do_not_look_alike() -> None:
    codes = {fingerprint(f"{n:064x}") for n in range(500)}
    assert len(codes) == 500
    assert not set("".join(codes)) & set("0O1IL5S2Z8BU")
    assert {len(code) for code in codes} == {14}
