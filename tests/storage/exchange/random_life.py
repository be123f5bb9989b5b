"""Random operations on the store of a PC, including merges of other PCs' bundles."""

import random
import struct
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

from storage import ClassroomRow, GroupRow, ProgramRow, RunRow, Store, StoreError
from storage.choices import TRUTH_SOURCES
from storage.limits import N_FEATURES
from tests.storage.bundle_makers import merged, removed, work

T = TypeVar("T")
Deed = Callable[[], None]
_RARE = 0.2


class RandomLife:
    """Performs random operations on a store; deterministic for a seed."""

    def __init__(self, store: Store, chance: random.Random, bundles: list[Path]) -> None:
        self._store = store
        self._chance = chance
        self._bundles = bundles
        self._common: tuple[Deed, ...] = (
            *(self._make_group, self._make_class, self._work, self._save, self._open),
            *(self._rename_group, self._rename_class, self._throw_away, self._note),
            *(self._teach, self._make_activity, self._preset, self._measure),
            self._calibrate,
        )
        self._rare: tuple[Deed, ...] = (
            *(self._delete_class, self._delete_group, self._delete_program, self._delete_run),
            *(self._forget_sign, self._delete_activity, self._delete_calibrated),
            *(self._merge,) * 4,
        )

    def advance(self, n_steps: int) -> None:
        for _ in range(n_steps):
            rare = self._chance.random() < _RARE
            self._chance.choice(self._rare if rare else self._common)()

    def _name(self) -> str:
        return f"{self._chance.randrange(10**9)}"

    def _make_group(self) -> None:
        classroom = self._classroom()
        self._store.groups.create(self._name(), classroom_id=classroom.id if classroom else None)

    def _make_class(self) -> None:
        self._store.classrooms.create(self._name())

    def _work(self) -> None:
        if group := self._group():
            work(self._store, group, self._name())

    def _save(self) -> None:
        if program := self._program():
            self._store.versions.save(program.id, {"text": self._name()}, None)

    def _open(self) -> None:
        if classroom := self._classroom():
            self._store.lessons.open(classroom.id, f"Aula {self._chance.randrange(2)}")

    def _rename_group(self) -> None:
        if group := self._group():
            self._store.groups.change(group.id, {"name": self._name()})

    def _rename_class(self) -> None:
        if classroom := self._classroom():
            self._store.classrooms.rename(classroom.id, self._name())

    def _throw_away(self) -> None:
        if program := self._program():
            self._store.programs.move_to_bin(program.id)

    def _note(self) -> None:
        if run := self._run():
            self._store.notes.write(run.id, self._name())

    def _measure(self) -> None:
        if run := self._run():
            x, source = self._chance.random(), self._chance.choice(TRUTH_SOURCES)
            self._store.truths.record(run.id, source, [(None, x, 0.0, 0.0, 0.01, 0.03)])

    def _teach(self) -> None:
        if classroom := self._classroom():
            sign, value = self._chance.choice("F78"), self._chance.random()
            with suppress(StoreError):  # taught enough
                self._store.taught_signs.add(
                    classroom.id,
                    sign,
                    struct.pack("<e", value) * N_FEATURES,
                    is_moving=self._chance.random() < 0.3,
                )

    def _forget_sign(self) -> None:
        classroom = self._classroom()
        taught = self._store.taught_signs.of_classroom(classroom.id) if classroom else []
        if classroom and (one := self._one_of(taught)):
            removed(self._store, *self._store.taught_signs.keys(classroom.id, one.sign))

    def _make_activity(self) -> None:
        known = [one.id for one in self._store.own_activities.all()]
        again = known and self._chance.random() < 0.5
        key = self._chance.choice(known) if again else self._store.own_activities.new_key()
        document = {"pinel_activity": 2, "name": key, "title": {}, "checks": [], "cases": []}
        goal: dict[str, object] = {"lines": [], "zones": [], "boxes": {}}
        self._store.own_activities.save(key, self._name(), document, goal)

    def _delete_activity(self) -> None:
        if one := self._one_of(self._store.own_activities.all()):
            self._store.own_activities.delete(one.id)

    def _calibrate(self) -> None:
        values = {"track_m": 0.3 + self._chance.random() / 10}
        self._store.calibrated_robots.create(self._name(), "pioneer_3dx", values, {"runs": []})

    def _delete_calibrated(self) -> None:
        if one := self._one_of(self._store.calibrated_robots.all()):
            self._store.calibrated_robots.delete(one.id)

    def _preset(self) -> None:
        if classroom := self._classroom():
            self._store.class_presets.set(classroom.id, {"level": self._chance.randrange(1, 4)})

    def _delete_class(self) -> None:
        if classroom := self._classroom():
            removed(self._store, classroom.id)

    def _delete_group(self) -> None:
        if group := self._group():
            removed(self._store, group.id)

    def _delete_program(self) -> None:
        if program := self._program():
            removed(self._store, program.id)

    def _delete_run(self) -> None:
        if run := self._run():
            removed(self._store, run.id)

    def _merge(self) -> None:
        if self._bundles:
            merged(self._store, self._chance.choice(self._bundles))

    def _classroom(self) -> ClassroomRow | None:
        return self._one_of(self._store.classrooms.all())

    def _group(self) -> GroupRow | None:
        return self._one_of(self._store.groups.all())

    def _program(self) -> ProgramRow | None:
        groups = self._store.groups.all()
        return self._one_of(
            [p for group in groups for p in self._store.programs.of_group(group.id)]
        )

    def _run(self) -> RunRow | None:
        return self._one_of(self._store.runs.newest(50))

    def _one_of(self, found: Sequence[T]) -> T | None:
        return self._chance.choice(found) if found else None
