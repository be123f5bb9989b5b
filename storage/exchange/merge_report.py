"""What a merge did."""

from dataclasses import dataclass
from pathlib import Path

from storage.exchange.bundle_writing import BundleInfo
from storage.exchange.deleting.deletion import Exported
from storage.exchange.deleting.pending import PendingDeletion, PendingWork


@dataclass(frozen=True, slots=True)
class MergeReport:
    """What a merge did: numbers of rows by table, without zeros.

    Attributes:
        added: rows that were not in the store.
        changed: rows of which the bundle had a later state.
        skipped: rows that were left out, as they or what they belong to was deleted from the store.
        removed: rows of the store that were deleted, as the bundle has tombstones for them.
        would_delete: rows of the store that a merge with `delete` would delete, None where it was done or for nothing.
        retained: what was kept here, and is kept from now on wherever the store's bundles go.
        tombstones: keys of what was deleted; backups are to lose the same.
        exports: files that were written from this store and may still hold it.
        still_in: backups that could not be written anew, and may hold it.
        n_unconfirmed: runs of it whose pass does not count here yet.
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

    @property
    def left_in(self) -> list[str]:
        """Files that people have to delete by hand, as they may hold what was deleted."""
        return [one.path for one in self.exports] + [str(path) for path in self.still_in]

    @property
    def nothing_new(self) -> bool:
        """All of it was in the store already, or was deleted from it."""
        return not (
            self.added or self.changed or self.removed or self.would_delete or self.retained
        )
