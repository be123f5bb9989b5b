"""Deletions that came with a file and that nobody has decided yet: merging the file again asks again."""

from dataclasses import asdict, dataclass, fields

from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.deleting.pending import PendingDeletion
from storage.file.connection import Database
from storage.sqlite import sqlite3
from storage.work.settings import read_setting, write_setting

_NAME = "undecided_deletions"


@dataclass(frozen=True, slots=True)
class UnresolvedDeletion:
    """Rows that were deleted for good on another PC and are still in this store.

    Attributes:
        computer_id, computer: the PC that wrote the file.
        path: the newest file with the deletion.
        groups, programs, runs: how many rows of each would be deleted.
    """

    computer_id: str
    computer: str
    path: str
    exported_at: str
    groups: int
    programs: int
    runs: int


def record_unresolved(
    db: sqlite3.Connection, info: BundleInfo, pending: PendingDeletion | None
) -> None:
    """Records the deletions of the newest file of a PC that are unresolved, within the caller's transaction."""
    before = _stored(db)
    left = {one.computer_id: one for one in before}
    known = left.pop(info.computer_id, None)
    if known is not None and info.exported_at < known.exported_at:
        return  # an older file lacks later deletions of the PC
    if pending is not None:
        left[info.computer_id] = UnresolvedDeletion(
            info.computer_id,
            info.computer_name,
            str(info.path.absolute()),
            info.exported_at,
            pending.groups,
            pending.programs,
            pending.runs,
        )
    if list(left.values()) != before:
        write_setting(db, _NAME, [asdict(one) for one in left.values()])


def unresolved_deletions(database: Database) -> list[UnresolvedDeletion]:
    """Returns one entry for each PC, in the order of the merges."""
    with database.read_connection() as db:
        return _stored(db)


def _stored(db: sqlite3.Connection) -> list[UnresolvedDeletion]:
    stored, names = read_setting(db, _NAME), {field.name for field in fields(UnresolvedDeletion)}
    whole = [one for one in stored or [] if isinstance(one, dict) and one.keys() == names]
    return [UnresolvedDeletion(**one) for one in whole]
