"""PCs of a lab whose people delete, move and keep the same work."""

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path

from storage import Store
from storage.exchange.deleting.pending import PendingWork
from tests.attacks.made_up_files import forged
from tests.storage.bundle_makers import a_run, a_store, exported, hash_of, merged, removed, work


class Lab:
    """Makes PCs and files in a folder."""

    def __init__(self, folder: Path, stack: ExitStack) -> None:
        self._folder = folder
        self._stack = stack
        self._n = 0

    def pc(self) -> Store:
        """A new PC."""
        return self._stack.enter_context(a_store(self._path("db")))

    def file(self, store: Store) -> Path:
        """All work of a PC."""
        return exported(store, self._path("pinel")).path

    def hash_of_a_new_pc(self, files: Sequence[Path]) -> str:
        """After it merged the files in this order."""
        store = self.pc()
        for file in files:
            merged(store, file)
        return hash_of(store)

    def class_deleted_while_its_group_moved(self) -> list[Path]:
        """Of the PC that deleted the class, and of the other before and after the group was moved."""
        here, there = self.pc(), self.pc()
        old, new = (here.classrooms.create(name) for name in ("8º B", "9º B"))
        merged(there, self.file(here))
        group = there.groups.create("Onças", classroom_id=old.id)
        work(there, group, "P")
        before = self.file(there)
        there.groups.change(group.id, {"classroom_id": new.id})
        removed(here, old.id)
        return [self.file(here), before, self.file(there)]

    def everybody_merges_after_class_deleted_and_group_moved(
        self, order: Sequence[int]
    ) -> tuple[set[str], list[set[str]]]:
        """Hashes, and names of the group's programs by PC; each PC in its turn merges the others' work, twice."""
        pcs = [self.pc() for _ in range(3)]
        old, new = (pcs[0].classrooms.create(name) for name in ("8º B", "9º B"))
        group = pcs[0].groups.create("Onças", classroom_id=old.id)
        work(pcs[0], group, "before")
        for pc in pcs[1:]:
            merged(pc, self.file(pcs[0]))
        removed(pcs[0], old.id)
        pcs[1].groups.change(group.id, {"classroom_id": new.id})
        work(pcs[1], group, "where it was moved")
        work(pcs[2], group, "on the third PC")
        for pc in [pcs[n] for n in order] * 2:
            for other in pcs:
                if other is not pc:
                    merged(pc, self.file(other), retain_newer=True)
        programs = [{one.name for one in pc.programs.of_group(group.id)} for pc in pcs]
        return {hash_of(pc) for pc in pcs}, programs

    def class_deleted_where_its_group_had_left_and_here_it_was_worked_in(
        self,
    ) -> tuple[set[str], set[str], set[str]]:
        """What the question names; the group's programs here afterwards; hashes of both PCs in the end."""
        here, there = self.pc(), self.pc()
        old = here.classrooms.create("8º B")
        group = here.groups.create("Onças", classroom_id=old.id)
        merged(there, self.file(here))
        there.groups.change(group.id, {"classroom_id": None})
        removed(there, old.id)
        work(here, group, "só aqui")
        for name in ("Onças 2", "Onças 3"):  # two revisions later, here it is still in the class
            here.groups.change(group.id, {"name": name})
        file = self.file(there)
        asked = merged(here, file, delete=False).would_delete
        merged(here, file)
        programs = {one.name for one in here.programs.of_group(group.id)}
        merged(there, self.file(here))
        return set(asked.names if asked else ()), programs, {hash_of(here), hash_of(there)}

    def run_deleted_there_then_its_group_here(self) -> tuple[str, str]:
        """Hashes; the deletion of the run was not confirmed at first."""
        here, there = self.pc(), self.pc()
        group = here.groups.create("Onças")
        _, run_id = work(here, group, "P")
        merged(there, self.file(here))
        removed(there, run_id)
        file = self.file(there)
        merged(here, file, delete=False)
        removed(here, group.id)
        merged(here, file)
        merged(there, self.file(here))
        return hash_of(here), hash_of(there)

    def group_deleted_there_and_worked_on_here(self) -> tuple[Sequence[PendingWork], set[str]]:
        """What is asked, and the groups left after the usual answer."""
        here, there, _ = self._deleted_there()
        file = self.file(there)
        pending = merged(here, file, delete=False).would_delete
        assert pending is not None
        merged(here, file, retain_newer=True)
        return pending.work, names(here)

    def groups_after_it_was_retained_and_old_files_came(self) -> list[set[str]]:
        """Of both PCs."""
        here, there, _ = self._deleted_there()
        old = self.file(there)
        merged(here, old, retain_newer=True)
        merged(there, self.file(here))
        for store in (here, there):
            merged(store, old)
        return [names(here), names(there)]

    def deleted_again_after_it_was_retained(self) -> tuple[set[str], list[set[str]]]:
        """What is asked, and the groups left on both PCs."""
        here, there, group_id = self._deleted_there()
        merged(here, self.file(there), retain_newer=True)
        merged(there, self.file(here))
        removed(there, group_id)
        file = self.file(there)
        pending = merged(here, file, delete=False).would_delete
        assert names(here) == {"Onças"}
        merged(here, file)
        merged(there, self.file(here))
        return {one.name for one in pending.work} if pending else set(), [names(here), names(there)]

    def deleted_after_a_forged_retention(self, turn: int) -> list[set[str]]:
        """The groups left on both PCs; a made-up file had decided that the group stays."""
        here, there = self.pc(), self.pc()
        group = here.groups.create("Onças")
        work(here, group, "P")
        retention = f"INSERT INTO deletions VALUES ('{group.id}', {turn}, '{{}}')"
        file = forged(self.file(here), f"INSERT INTO tombstones VALUES ('{group.id}'); {retention}")
        for store in (here, there):
            merged(store, file)
        removed(here, group.id)
        merged(there, self.file(here))
        return [names(here), names(there)]

    def _deleted_there(self) -> tuple[Store, Store, str]:
        """A group that was deleted with its class there, and moved and worked on here."""
        here, there = self.pc(), self.pc()
        old, new = (here.classrooms.create(name) for name in ("8º B", "9º B"))
        group = here.groups.create("Onças", classroom_id=old.id)
        program, _ = work(here, group, "P")
        merged(there, self.file(here))
        removed(there, old.id)
        here.groups.change(group.id, {"classroom_id": new.id})
        version = here.versions.newest(program.id)
        assert version is not None
        a_run(here, version.id)
        return here, there, group.id

    def _path(self, suffix: str) -> Path:
        self._n += 1
        return self._folder / f"{self._n}.{suffix}"


def names(store: Store) -> set[str]:
    """Of its groups."""
    return {group.name for group in store.groups.all()}
