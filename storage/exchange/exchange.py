"""What goes between stores: exported, merged, compared, heard of; and what is to go from all of them."""

import tempfile
from collections.abc import Collection
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from storage.anonymous import anonymising
from storage.backups import Stop, remove_from_backups
from storage.bundles import ALL, BundleInfo, Scope, export_bundle, note_export
from storage.connection import Access
from storage.content import content_hash
from storage.merging import Heard, MergeReport, heard_from, merge
from storage.opening import connect
from storage.parquet import write_parquet
from storage.program_merging import merge_program
from storage.removal import Removal, forget_log, remove, remove_keys, tombstones
from storage.text import new_id


class Exchange:
    """The store's side of exporting and merging."""

    def __init__(self, access: Access) -> None:
        self._access = access

    def export(
        self,
        dest: Path,
        *,
        app_version: str,
        computer: tuple[str, str],
        scope: Scope = ALL,
        is_noted: bool = True,
        anonymous: Collection[str] | None = None,
    ) -> BundleInfo:
        """Writes a bundle; see `export_bundle`.

        Args:
            anonymous: leaves names and texts out, but for these of worlds and activities that ship.
        """
        return export_bundle(
            self._access,
            dest,
            app_version=app_version,
            computer=computer if anonymous is None else (new_id(), "PC"),
            scope=scope,
            is_noted=is_noted,
            alter=None if anonymous is None else anonymising(anonymous),
        )

    def export_parquet(
        self,
        dest: Path,
        *,
        app_version: str,
        computer: tuple[str, str],
        scope: Scope = ALL,
        anonymous: Collection[str] | None = None,
    ) -> BundleInfo:
        """Writes a folder of Parquet files; see `write_parquet`, and `export` for the rest."""
        with tempfile.TemporaryDirectory(prefix="pinel-") as folder:
            info = self.export(
                Path(folder) / "bundle",
                app_version=app_version,
                computer=computer,
                scope=scope,
                is_noted=False,
                anonymous=anonymous,
            )
            info = replace(info, path=write_parquet(info.path, dest))
        note_export(self._access, info, scope)
        return info

    def merge(self, path: Path, *, delete: bool = False) -> MergeReport:
        """Brings a bundle in; on disk when this returns.

        Args:
            delete: also deletes here, and from the log and the backups, what was deleted for good where the bundle
                is from; without it the report only tells what that is.

        Raises:
            StoreError: see `merging.merge`.
        """
        report = merge(self._access, path, delete=delete)
        if report.removed:
            with closing(connect(self._access.address)) as db:
                forget_log(db)
            report = replace(report, still_in=self._clean_backups(report.buried))
        return report

    def merge_program(self, path: Path) -> tuple[MergeReport, str]:
        """Brings in what is new of one program, whose key it tells too; see `program_merging.merge_program`."""
        return merge_program(self._access, path)

    def heard_from(self) -> list[Heard]:
        """PCs whose bundles were merged, the one heard of last first."""
        return heard_from(self._access)

    def remove(self, kind: str, key: str) -> Removal:
        """Deletes for good a `classroom`, `group`, `program`, `run`, `lesson` or `note`, also from the backups; see
        `removal.remove`."""
        removal = remove(self._access, kind, key)
        return replace(removal, still_in=self._clean_backups(removal.ids))

    def finish_removals(self, stop: Stop = lambda: False) -> tuple[Path, ...]:
        """Takes what was deleted for good out of backups that hold it yet, and out of the log: of a removal that was
        cut off, while somebody else held a backup, or while one was being made. Those that still hold it are told."""
        with self._access.reading() as db:
            ids = tombstones(db)
        if not ids:
            return ()
        with closing(connect(self._access.address)) as db:
            db.execute("PRAGMA busy_timeout = 0")  # who writes does not wait: it is tried again
            forget_log(db)
        return self._clean_backups(ids, stop)

    def _clean_backups(self, ids: Collection[str], stop: Stop = lambda: False) -> tuple[Path, ...]:
        return tuple(remove_from_backups(self._access.path, ids, remove_keys, stop))

    def content_hash(self) -> str:
        """One number for all that the store holds; equal stores have equal ones."""
        with self._access.reading() as db:
            return content_hash(db)
