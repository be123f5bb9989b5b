"""Histories of several PCs in memory, made by chance: work, moves, deletions, merges, and what people decide.

A PC is a store's tables without files: merging attaches the other PC's tables as a bundle. Bundles as files, with all
that is checked of them, are the matter of other tests; here the rules of merging are tried in many histories.
"""

import itertools
import random
from collections.abc import Collection
from functools import cache
from pathlib import Path

from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.content_hash import content_hash
from storage.exchange.deleting.deletion import purge_keys
from storage.exchange.merge_report import MergeReport
from storage.exchange.merging import merge_attached
from storage.sql import insert
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate
from storage.text import new_id

NOW = "2026-03-02T08:00:00Z"
_names = itertools.count()
_KINDS = ("classrooms", "groups", "programs", "versions", "runs")


@cache
def _empty() -> sqlite3.Connection:
    db = sqlite3.connect(":memory:", isolation_level=None)
    migrate(db)
    return db


class Pc:
    """The tables of one PC, with the deeds of the people at it."""

    def __init__(self) -> None:
        self.address = f"file:pc{next(_names)}?mode=memory&cache=shared"
        self.db = sqlite3.connect(self.address, uri=True, isolation_level=None)
        self.db.row_factory = sqlite3.Row
        _empty().backup(self.db)
        self.db.execute("PRAGMA foreign_keys = ON")
        self.id = new_id()

    def copy(self) -> "Pc":
        """The PC as its file of this moment tells of it."""
        other = Pc()
        self.db.backup(other.db)
        other.id = self.id
        return other

    def close(self) -> None:
        """Forgets it all."""
        self.db.close()

    def keys(self) -> dict[str, str]:
        """Keys of all rows with the table that they are in."""
        return {key: table for table in _KINDS for (key,) in self.all(f"SELECT id FROM {table}")}

    def all(self, query: str) -> list[tuple[str, ...]]:
        return [tuple(row) for row in self.db.execute(query)]

    def hash(self) -> str:
        return content_hash(self.db)

    def problems(self) -> list[object]:
        return list(self.db.execute("PRAGMA foreign_key_check"))

    def add(self, table: str, **values: object) -> None:
        """A row with what a store gives it."""
        insert(self.db, table, {"id": new_id(), "created_at": NOW, **values})

    def make_group(self, classroom_id: str | None, name: str) -> None:
        """A new group."""
        appearance = {"color": "#000000", "picture": "", "name_key": name}
        self.add("groups", name=name, classroom_id=classroom_id, used_at=NOW, **appearance)

    def save(self, program_id: str) -> None:
        """A new version of a program."""
        work = {"workspace": "{}", "faults": "[]"}
        self.add("versions", program_id=program_id, number=1, computer_id=self.id, **work)

    def run(self, program_id: str, group_id: str, version_id: str | None) -> None:
        """A run of a program."""
        row = {
            "id": new_id(),
            "program_id": program_id,
            "group_id": group_id,
            "version_id": version_id,
        }
        setup = {"link": "sim", "world": "w", "world_document": "{}", "seed": 1, "parameters": "{}"}
        ended = {"app_version": "1", "state": "finished", "started_at": NOW, "computer_id": self.id}
        insert(self.db, "runs", row | setup | ended)

    def rename(self, group_id: str, name: str) -> None:
        """Another name of a group."""
        self.db.execute(
            "UPDATE groups SET name = ?, revision = revision + 1 WHERE id = ?", [name, group_id]
        )

    def move(self, group_id: str, classroom_id: str | None) -> None:
        """Another class of a group, noted as `groups.change` does."""
        self.db.execute(
            "INSERT OR IGNORE INTO former_classes SELECT id, classroom_id, 0 FROM groups"
            " WHERE id = ? AND classroom_id IS NOT ? AND classroom_id IS NOT NULL",
            [group_id, classroom_id],
        )
        self.db.execute(
            "UPDATE groups SET classroom_id = ?, revision = revision + 1 WHERE id = ?",
            [classroom_id, group_id],
        )

    def remove(self, key: str) -> None:
        """Deletes a row for good."""
        self.db.execute("BEGIN")
        purge_keys(self.db, [key])
        self.db.execute("COMMIT")

    def merge(
        self,
        other: "Pc",
        *,
        delete: bool,
        retained: Collection[str] = (),
        retain_newer: bool = False,
    ) -> MergeReport:
        """Merges another PC's work."""
        unchanged = (
            f"{other.address} {other.db.total_changes}"  # in place of its hash, which takes long
        )
        info = BundleInfo(Path("x"), "1", NOW, other.id, "PC", unchanged, {}, False)
        self.db.execute("ATTACH DATABASE ? AS bundle", [other.address])
        self.db.execute("BEGIN")
        try:
            report = merge_attached(
                self.db, info, NOW, delete=delete, retained=retained, retain_newer=retain_newer
            )
            self.db.execute("COMMIT")
        finally:
            self.db.execute("DETACH DATABASE bundle")
        return report


class History:
    """What happened at several PCs; `deleted` has what people deleted, or let be deleted after they were asked."""

    def __init__(self, chance: random.Random) -> None:
        self.chance = chance
        self.pcs = [Pc() for _ in range(chance.randint(3, 6))]
        self.deleted: set[str] = set()
        self.made: set[str] = set()

    def close(self) -> None:
        """Forgets it all."""
        for pc in self.pcs:
            pc.close()

    def advance(self, n_steps: int) -> None:
        """Lets something happen so many times."""
        for _ in range(n_steps):
            pc = self.chance.choice(self.pcs)
            before = set(pc.keys())
            self._happens(pc)
            after = set(pc.keys())
            self.made |= after
            self.deleted |= before - after

    def exchange(self, max_rounds: int = 12) -> int:
        """One PC merges the work of all and all merge its work, by chance which, and decide, until nothing changes;
        tells in how many rounds."""
        before: set[str] = set()
        for n in range(max_rounds):
            hub, *others = self._any_order(self.pcs)
            for pc in others:
                self.merge(hub, pc, decides=True)
            for pc in others:
                self.merge(pc, hub, decides=True)
            found = {pc.hash() for pc in self.pcs}
            if len(found) == 1 and found == before:
                return n
            before = found
        raise AssertionError(f"no end after {max_rounds} rounds")

    def merge(self, pc: Pc, other: Pc, *, decides: bool) -> None:
        """A merge: nothing goes without being asked, and only what was named; nothing goes that is to be kept."""
        before = set(pc.keys())
        asked = pc.merge(other, delete=False).would_delete
        assert before <= set(pc.keys()), "deleted without being asked"
        if asked is None or not decides:
            return
        present = pc.keys()
        some = {one.id for one in asked.work if self.chance.random() < 0.5}
        retained, retain_newer = self.chance.choice(
            (((), True), ((), True), ((), False), (some, False))
        )
        report = pc.merge(other, delete=True, retained=retained, retain_newer=retain_newer)
        deleted = present.keys() - pc.keys().keys()
        if not report.retained:
            counts = [
                sum(present[key] == table for key in deleted)
                for table in ("groups", "programs", "runs")
            ]
            assert counts == [asked.groups, asked.programs, asked.runs], "not what was named"
        chosen = set(asked.newer if retain_newer else retained)
        assert {one.id for one in report.retained} == chosen
        assert not deleted & chosen, "deleted what was to be kept"
        self.deleted |= deleted

    def _any_order(self, pcs: list[Pc]) -> list[Pc]:
        return self.chance.sample(pcs, len(pcs))

    def _one(self, pc: Pc, query: str) -> tuple[str, ...] | None:
        found = pc.all(query)
        return self.chance.choice(found) if found else None

    def _happens(self, pc: Pc) -> None:
        chance = self.chance.random()
        name = str(self.chance.randrange(10**9))
        classroom = self._one(pc, "SELECT id FROM classrooms")
        group = self._one(pc, "SELECT id FROM groups")
        program = self._one(pc, "SELECT id, group_id FROM programs")
        if chance < 0.08 or classroom is None:
            pc.add("classrooms", name=name)
        elif chance < 0.18 or group is None:
            pc.make_group(classroom[0] if self.chance.random() < 0.8 else None, name)
        elif chance < 0.28 or program is None:
            pc.add("programs", group_id=group[0], name=name, updated_at=NOW)
        elif chance < 0.38:
            pc.save(program[0])
        elif chance < 0.48:
            version = self._one(pc, f"SELECT id FROM versions WHERE program_id = '{program[0]}'")
            pc.run(program[0], program[1], version[0] if version else None)
        elif chance < 0.53:
            pc.rename(group[0], name)
        elif chance < 0.65:
            pc.move(group[0], classroom[0] if self.chance.random() < 0.8 else None)
        elif chance < 0.75:
            self._remove(pc)
        else:
            other = self.chance.choice([one for one in self.pcs if one is not pc])
            self.merge(pc, other, decides=self.chance.random() < 0.5)

    def _remove(self, pc: Pc) -> None:
        table = self.chance.choice(("classrooms", "classrooms", "groups", "programs", "runs"))
        if one := self._one(pc, f"SELECT id FROM {table}"):
            pc.remove(one[0])
