"""Bundles that no PINEL wrote, or not all of it: refused with the reason, the store untouched."""

import contextlib
import os
import random
import zlib
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from storage import Store, StoreError, open_store
from storage.exchange import bundle_reading
from storage.exchange.content_hash import content_hash
from storage.limits import MAX_NUMBERS_AHEAD, MAX_REVISION
from storage.runs.telemetry import COLUMNS, pack
from storage.sqlite import sqlite3
from storage.tables.columns import Table
from storage.tables.ddl import MIGRATIONS
from storage.tables.replicated import TABLES
from tests.storage.bundle_makers import exported, give_keys_of_before, hash_of, merged, work

Change = Callable[[sqlite3.Connection], object]


@pytest.fixture(scope="module")
def untouched(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Store]:
    """A store that nothing of what is refused ever gets into."""
    with open_store(tmp_path_factory.mktemp("here") / "here.db") as store:
        work(store, store.groups.create("Daqui"), "Programa")
        yield store


@pytest.fixture
def refused(untouched: Store) -> Callable[[Path], StoreError]:
    """Merges a file that must be refused, and sees that the store is as it was."""

    def attempt(path: Path) -> StoreError:
        before = hash_of(untouched)
        with pytest.raises(StoreError) as caught:
            merged(untouched, path)
        assert hash_of(untouched) == before
        return caught.value

    return attempt


def changed(
    path: Path, change: Change | str, *, honest: bool = True, of_before: bool = True
) -> Path:
    """The bundle after a change by hand; an honest one has a new checksum, one of before 0.3 keys that tell nothing."""
    with closing(sqlite3.connect(path, isolation_level=None)) as db:
        db.execute("PRAGMA foreign_keys = OFF")
        if honest and of_before:
            give_keys_of_before(db)
        if isinstance(change, str):
            db.executescript(change)
        else:
            change(db)
        if honest:
            db.execute("UPDATE bundle SET content_hash = ?", [content_hash(db)])
    return path


class TestNotABundle:
    def test_no_file(self, tmp_path: Path, refused: Callable[[Path], StoreError]) -> None:
        assert refused(tmp_path / "none.pinel").code == "bundle_missing"
        assert refused(tmp_path).code == "bundle_missing"

    @pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes")
    def test_a_pipe_does_not_hang(
        self, tmp_path: Path, refused: Callable[[Path], StoreError]
    ) -> None:
        os.mkfifo(tmp_path / "pipe.pinel")
        assert refused(tmp_path / "pipe.pinel").code == "bundle_missing"

    @pytest.mark.parametrize(
        ("octets", "code"),
        [
            (b"", "bundle_damaged"),
            (b"SQLite for", "bundle_damaged"),
            (b"a letter to the teacher", "bundle_foreign"),
            (b"\x89PNG\r\n\x1a\n" + bytes(500), "bundle_foreign"),
            (b"SQLite format 3\0" + bytes(500), "bundle_damaged"),
        ],
    )
    def test_other_files(
        self, tmp_path: Path, refused: Callable[[Path], StoreError], octets: bytes, code: str
    ) -> None:
        (tmp_path / "x.pinel").write_bytes(octets)
        assert refused(tmp_path / "x.pinel").code == code

    def test_a_database_of_another_program(
        self, tmp_path: Path, refused: Callable[[Path], StoreError]
    ) -> None:
        for n, script in enumerate(("CREATE TABLE moz_places (id)", "CREATE TABLE groups (id)")):
            with closing(sqlite3.connect(tmp_path / f"{n}.pinel")) as db:
                db.executescript(script)
            assert refused(tmp_path / f"{n}.pinel").code == "bundle_foreign"

    def test_the_file_that_an_app_works_in(
        self, tmp_path: Path, opened: Callable[..., Store], refused: Callable[[Path], StoreError]
    ) -> None:
        opened(tmp_path / "other.db").close()
        assert refused(tmp_path / "other.db").code == "bundle_is_store"


class TestDamaged:
    @pytest.mark.parametrize("share", [0.001, 0.1, 0.5, 0.9, 0.999])
    def test_cut_off(
        self, bundle: Path, refused: Callable[[Path], StoreError], share: float
    ) -> None:
        octets = bundle.read_bytes()
        bundle.write_bytes(octets[: int(len(octets) * share)])
        assert refused(bundle).code == "bundle_damaged"

    @pytest.mark.parametrize("seed", range(30))
    def test_a_flipped_bit_is_noticed_or_changes_nothing(
        self, bundle: Path, store: Store, tmp_path: Path, seed: int
    ) -> None:
        octets = bytearray(bundle.read_bytes())
        octets[random.Random(seed).randrange(100, len(octets))] ^= 1 << seed % 8
        flipped = tmp_path / "flipped.pinel"
        flipped.write_bytes(octets)
        before = hash_of(store)
        with contextlib.suppress(StoreError):
            merged(store, flipped)
            before = hash_of(store)
            assert merged(store, bundle).nothing_new
        assert hash_of(store) == before

    def test_changed_content_does_not_fit_its_checksum(
        self, bundle: Path, refused: Callable[[Path], StoreError]
    ) -> None:
        changed(bundle, "UPDATE groups SET name = 'Outro'", honest=False)
        assert refused(bundle).params["problem"] == "checksum"

    def test_without_what_it_says_of_itself(
        self, bundle: Path, refused: Callable[[Path], StoreError]
    ) -> None:
        assert refused(changed(bundle, "DELETE FROM bundle")).code == "bundle_damaged"


class TestOtherReleases:
    @pytest.mark.parametrize(
        "script",
        [
            "INSERT INTO _sqlite_migrations VALUES (99, 'pinel', 'holograms', 't')",
            "UPDATE bundle SET format = 2",
            "ALTER TABLE bundle ADD COLUMN signature TEXT; UPDATE bundle SET format = 2",
        ],
    )
    def test_a_newer_one(
        self, bundle: Path, refused: Callable[[Path], StoreError], script: str
    ) -> None:
        assert refused(changed(bundle, script)).code == "bundle_newer"

    def test_an_older_one_is_brought_up_to_date_on_a_copy(
        self,
        bundle: Path,
        tmp_path: Path,
        opened: Callable[..., Store],
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        before = bundle.read_bytes()
        monkeypatch.setitem(MIGRATIONS, "mottos", ("ALTER TABLE groups ADD COLUMN motto TEXT",))
        monkeypatch.setitem(TABLES, "mottos", Table("mottos", "not in the older one", ()))
        bundle_reading._expected.cache_clear()
        store = opened(tmp_path / "newer.db")
        assert merged(store, bundle).added["runs"] == 2
        assert store.groups.all()[0].name == "Onças"
        assert bundle.read_bytes() == before
        bundle_reading._expected.cache_clear()


# what a bundle must not bring along, as objects of the file
OBJECTS = {
    "a trigger": "CREATE TRIGGER evil AFTER INSERT ON groups BEGIN DELETE FROM groups; END",
    "another table": "CREATE TABLE evil (x)",
    "a view": "CREATE VIEW evil AS SELECT load_extension('evil')",
    "a changed view": "DROP VIEW group_list; CREATE VIEW group_list AS SELECT randomblob(1e9)",
    "a view that never ends": """DROP VIEW about; CREATE VIEW about AS
        WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i AS name, i AS meaning FROM n""",
    "a virtual table": "CREATE VIRTUAL TABLE evil USING fts5(x)",
    "a generated column": "ALTER TABLE runs ADD COLUMN evil TEXT AS (hex(zeroblob(1e6))) VIRTUAL",
    "an index by expression": "CREATE INDEX evil ON groups (length(zeroblob(1000000)))",
    "a missing index": "DROP INDEX notes_run",
    "a missing table": "DROP TABLE notes",
    "an additional column": "ALTER TABLE groups ADD COLUMN pupils TEXT",
    "a table without its types": """DROP TABLE computers; CREATE TABLE computers
        (id TEXT PRIMARY KEY, name TEXT NOT NULL, revision INTEGER NOT NULL DEFAULT 1, changed_at TEXT)""",
    "steps that never were": "DELETE FROM _sqlite_migrations WHERE name = 'first_views'",
}


@pytest.mark.parametrize("kind", OBJECTS)
def test_objects_that_pinel_does_not_make(
    bundle: Path, refused: Callable[[Path], StoreError], kind: str
) -> None:
    assert refused(changed(bundle, OBJECTS[kind], honest=False)).code == "bundle_hostile"


def test_a_table_of_steps_that_is_a_view_is_never_asked(
    bundle: Path, refused: Callable[[Path], StoreError]
) -> None:
    script = """DROP TABLE _sqlite_migrations; CREATE VIEW _sqlite_migrations AS
        WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)
        SELECT i AS name, 'pinel' AS migration_set FROM n"""
    assert refused(changed(bundle, script, honest=False)).code == "bundle_foreign"


_UUID = "0193a5b0-0000-7000-8000-00000000000"
_DEEP = "[" * 20_000 + "]" * 20_000
_SHALLOWER = "[" * 1500 + "]" * 1500
VALUES = {
    "a key that is a path": "UPDATE groups SET id = '../../etc/passwd'",
    "a name that is too long": "UPDATE groups SET name = printf('%.*c', 61, 'x')",
    "an empty name": "UPDATE programs SET name = ''",
    "a name that turns the direction": "UPDATE groups SET name = 'a' || char(8238) || 'b'",
    "a name with a line feed": "UPDATE classrooms SET name = 'a' || char(10)",
    "a colour that is style": "UPDATE groups SET color = 'red;background:url(x)'",
    "a picture that is a path": "UPDATE groups SET picture = '../../x.svg'",
    "a robot's name that turns the direction": "UPDATE groups SET robot_name = 'a' || char(8238)",
    "a robot's name that is too long": "UPDATE groups SET robot_name = printf('%.*c', 61, 'x')",
    "a pattern that is style": "UPDATE groups SET robot_pattern = 'url(x)'",
    "a key of a time that no clock shows": "UPDATE notes SET id = '05ffffff-ffff-7fff-bfff-ffffffffffff'",
    "a number far beyond the count of versions": "UPDATE versions SET number = 10003",
    "a revision that no person reaches": "UPDATE groups SET revision = 1000001",
    "the last revision at a time to come": "UPDATE groups SET revision = 1000000, changed_at = '2127-01-01T00:00:00Z'",
    "a number that overflows": "UPDATE versions SET number = 9223372036854775807",
    "a revision that overflows": "UPDATE programs SET revision = 9223372036854775807",
    "a time that is none": "UPDATE runs SET started_at = 'yesterday'",
    "infinity": "UPDATE runs SET duration_s = 9e999",
    "a run that goes on": "UPDATE runs SET state = 'running'",
    "an unknown state": "UPDATE runs SET state = 'won'",
    "JSON that is none": "UPDATE versions SET workspace = '{'",
    "JSON of another kind": "UPDATE versions SET workspace = '[]'",
    "JSON that is too deep": f"""UPDATE versions SET workspace = '{{"a":{_DEEP}}}'""",
    "a document that is too deep": f"""UPDATE versions SET document = '{{"a":{_SHALLOWER}}}'""",
    "a deep workspace that is none": f"""UPDATE versions SET workspace = '{{"a":{_SHALLOWER}}},'""",
    "a deep workspace with infinity": f"""UPDATE versions SET workspace = '{{"a":{_SHALLOWER},"b":1e999}}'""",
    "JSON with infinity": """UPDATE runs SET summary = '{"a":1e999}'""",
    "JSON with a number of a million digits": """UPDATE runs SET summary = '{"a":1' || hex(zeroblob(99999)) || '}'""",
    "faults of another form": "UPDATE versions SET faults = '[1]'",
    "a path of another form": "UPDATE runs SET path = '[[1]]'",
    "events of another form": "UPDATE events SET data = '3'",
    "an event's type that is a path": "UPDATE events SET type = '../x'",
    "telemetry that is none": "UPDATE telemetry SET data = x'00112233'",
    "telemetry of other length": "UPDATE telemetry SET n_rows = n_rows + 1",
    "telemetry without rows": "UPDATE telemetry SET n_rows = 0",
    "hands that are none": "UPDATE taught_signs SET samples = x'00112233'",
    "a hand with infinity": "UPDATE taught_signs SET samples = CAST(substr(samples, 3) || x'007c' AS BLOB)",
    "a sign that moves neither nor rests": "UPDATE taught_signs SET is_moving = 2",
    "a sign's name that is a path": "UPDATE taught_signs SET sign = '../7'",
    "an activity that is none": "UPDATE own_activities SET document = '{}'",
    "a goal that is none": "UPDATE own_activities SET goal = '{\"lines\":1}'",
    "parameters of a robot that are no numbers": 'UPDATE calibrated_robots SET parameters = \'{"track_m":"x"}\'',
    "a robot's report that is none": "UPDATE calibrated_robots SET report = '[]'",
    "a preset that is none": "UPDATE class_presets SET preset = '[]'",
    "a note that is too long": "UPDATE notes SET text = printf('%.*c', 1001, 'x')",
    "a run of nobody": f"UPDATE runs SET group_id = '{_UUID}1' WHERE group_id IS NOT NULL",
    "a tombstone that is a text": "INSERT INTO tombstones VALUES ('João da Silva')",
    "a PC's name that is none": "UPDATE bundle SET computer_name = char(27) || '[31m'",
    "counts that are not true": """UPDATE bundle SET counts = '{"programs":1}'""",
    "huge texts": "UPDATE notes SET text = printf('%.*c', 20000000, 'x')",
}


@pytest.mark.parametrize("kind", VALUES)
def test_values_that_pinel_does_not_write(
    bundle: Path, refused: Callable[[Path], StoreError], kind: str
) -> None:
    assert refused(changed(bundle, VALUES[kind])).code == "bundle_hostile"


OTHER_VERSIONS = (
    "workspace = '{}'",
    "document = NULL",
    """faults = '[["a","",null,{}]]'""",
    "world = NULL",
    "setup = '{}'",
    "created_at = '2026-01-01T00:00:00Z'",
    *(f"{name} = id" for name in ("parent_id", "lesson_id", "computer_id")),
)


@pytest.mark.parametrize("change", OTHER_VERSIONS)
def test_another_version_in_the_place_of_that_whose_key_it_has(
    bundle: Path, refused: Callable[[Path], StoreError], change: str
) -> None:
    found = refused(changed(bundle, f"UPDATE versions SET {change}", of_before=False))
    assert (found.code, found.params["problem"]) == ("bundle_hostile", "versions.id")


MAX_VALUES = {
    "a run of an hour with the most commands": "UPDATE runs SET n_executed = 108000000",
    "a key of a block with NUL": "UPDATE runs SET block = 'a' || char(0) || 'b'",
    "a deep workspace": f"""UPDATE versions SET workspace = '{{"a":{_SHALLOWER},"b":{"1" * 450}}}'""",
}


@pytest.mark.parametrize("kind", MAX_VALUES)
def test_what_a_store_may_write_is_let_in(bundle: Path, store: Store, kind: str) -> None:
    assert merged(store, changed(bundle, MAX_VALUES[kind])).added["runs"] == 2


def test_after_the_largest_revision_and_number_work_still_travels(
    bundle: Path, store: Store, tmp_path: Path, opened: Callable[..., Store]
) -> None:
    changed(
        bundle,
        f"UPDATE groups SET revision = {MAX_REVISION}; UPDATE programs SET revision = {MAX_REVISION};"
        f"UPDATE versions SET number = {MAX_NUMBERS_AHEAD} + 2",
    )
    merged(store, bundle)
    (group,) = store.groups.all()
    (program,) = store.programs.of_group(group.id)
    store.groups.change(group.id, {"name": "Outro"})
    store.programs.rename(program.id, "Outro")
    version = store.versions.save(program.id, {"z": 1}, None)
    assert store.versions.newest(program.id) == version
    third = opened(tmp_path / "third.db")
    merged(third, exported(store, tmp_path / "third.pinel").path)
    assert third.programs.get(program.id).name == "Outro"
    assert third.versions.newest(program.id) is not None


def test_telemetry_that_unpacks_to_gigabytes(
    bundle: Path, refused: Callable[[Path], StoreError]
) -> None:
    bomb = zlib.compress(bytes(300_000_000), 9)
    change: Change = lambda db: db.execute("UPDATE telemetry SET data = ?", [bomb])  # noqa: E731
    assert refused(changed(bundle, change)).code == "bundle_hostile"


def test_many_chunks_that_unpack_to_gigabytes_together(
    bundle: Path, refused: Callable[[Path], StoreError]
) -> None:
    blob = pack(np.zeros((100_000, len(COLUMNS))))

    def change(db: sqlite3.Connection) -> None:
        (run_id,) = db.execute("SELECT run_id FROM telemetry").fetchone()
        db.executemany(
            "INSERT INTO telemetry VALUES (?, ?, 0, 100000, ?)",
            [(run_id, chunk, blob) for chunk in range(100, 103)],
        )

    assert refused(changed(bundle, change)).code == "bundle_hostile"


def test_text_that_is_not_utf_8(bundle: Path, refused: Callable[[Path], StoreError]) -> None:
    change: Change = lambda db: db.execute(  # noqa: E731
        "UPDATE groups SET name = CAST(x'ff41' AS TEXT)"
    )
    with closing(sqlite3.connect(bundle, isolation_level=None)) as db:
        change(db)
    assert refused(bundle).code == "bundle_damaged"


def test_an_index_that_does_not_fit_its_table(
    bundle: Path, refused: Callable[[Path], StoreError]
) -> None:
    def change(db: sqlite3.Connection) -> None:
        (sql,) = db.execute("SELECT sql FROM sqlite_schema WHERE name = 'notes_run'").fetchone()
        db.execute("PRAGMA writable_schema = ON")
        db.execute("DELETE FROM sqlite_schema WHERE name = 'notes_run'")
        db.execute("PRAGMA writable_schema = RESET")
        db.execute("UPDATE notes SET text = 'x'")
        db.execute(sql.replace("run_id", "text"))
        db.execute("PRAGMA writable_schema = ON")
        db.execute("UPDATE sqlite_schema SET sql = ? WHERE name = 'notes_run'", [sql])

    changed(bundle, change, honest=False)
    assert refused(bundle).code == "bundle_damaged"
