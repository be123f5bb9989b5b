"""The report of a merge."""

from dataclasses import dataclass
from pathlib import Path

from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.deleting.deletion import Exported
from storage.exchange.deleting.pending import PendingDeletion, PendingWork


@dataclass(frozen=True, slots=True)
class MergeReport:
    """The changes of a merge, as numbers of rows by table, without zeros.

    Attributes:
        added: rows that were not in the store.
        changed: rows whose state in the bundle was newer.
        skipped: rows that were left out, because they or their parents were deleted from the store.
        removed: rows of the store that were deleted, because the bundle has tombstones for them.
        would_delete: rows of the store that a merge with `delete` would delete; None for none, or if this merge
            deleted them.
        retained: groups and programs that were retained; the store's bundles retain them on other PCs too.
        tombstones: keys of the deleted rows, which must be deleted from the backups too.
        exports: files that were written from this store and may still hold deleted rows.
        still_in: backups that could not be rewritten and may still hold deleted rows.
        n_unconfirmed: number of the bundle's runs whose pass does not count on this PC yet.
        lesson_id: the newest lesson with work in the bundle, or the lesson that it was joined to; None without one.
    """

    info: BundleInfo
    added: dict[str, int]
    changed: dict[str, int]
    skipped: dict[str, int]
    removed: dict[str, int]
    would_delete: PendingDeletion | None = None
    retained: tuple[PendingWork, ...] = ()
    tombstones: tuple[str, ...] = ()
    exports: tuple[Exported, ...] = ()
    still_in: tuple[Path, ...] = ()
    n_unconfirmed: int = 0
    lesson_id: str | None = None

    @property
    def left_in(self) -> list[str]:
        """Paths of files that may hold deleted rows and that people have to delete by hand."""
        return [one.path for one in self.exports] + [str(path) for path in self.still_in]

    @property
    def nothing_new(self) -> bool:
        """True if every row of the bundle was in the store already, or was deleted from it."""
        return not (
            self.added or self.changed or self.removed or self.would_delete or self.retained
        )
