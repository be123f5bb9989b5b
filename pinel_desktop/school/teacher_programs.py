"""The teacher's own programs, for solutions of activities: in a group of this PC that pupils are not shown.

A program needs a group. The teacher's is made with the first program. Other PCs, to which its work is merged, show it
as any other group without a class.
"""

from pinel_desktop.messages import describe
from storage import GroupRow, ProgramRow, Store
from storage.text import name_key

_TEACHER_GROUP = "teacher_group"


def teacher_group(store: Store) -> str | None:
    """Returns the key of the teacher's group; None before the first program."""
    key = store.settings.get(_TEACHER_GROUP)
    return key if isinstance(key, str) else None


def create_program(store: Store, language: str) -> ProgramRow:
    """Adds a program of the teacher, and the group if there is none yet. Raises StoreError if it cannot be stored."""
    group = _group(store) or _new_group(store, language)
    number = group.n_programs + group.n_in_bin + 1
    name = describe("teacher_program", {"n": number}, language).message
    return store.programs.create(group.id, name)


def _group(store: Store) -> GroupRow | None:
    key = teacher_group(store)
    return next((one for one in store.groups.all() if one.id == key), None)


def _new_group(store: Store, language: str) -> GroupRow:
    name = describe("teacher_group", {}, language).message
    without_class = (one for one in store.groups.all() if one.classroom_id is None)
    # the teacher's group of another PC, which came by a merge, becomes that of this one
    merged = (one for one in without_class if name_key(one.name) == name_key(name))
    group = next(merged, None) or store.groups.create(name)
    store.settings.set(_TEACHER_GROUP, group.id)
    return group
