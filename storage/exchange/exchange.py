"""Exports and merges bundles and deletes for good: the store's side of the exchange between PCs."""

from collections.abc import Collection
from contextlib import closing
from dataclasses import replace
from pathlib import Path

from storage.exchange.anonymising import anonymising
from storage.exchange.backup_share import BackupShare
from storage.exchange.bundle_writing import (
    BundleInfo,
    export_bundle,
    forget_unconfirmed,
    record_export,
)
from storage.exchange.content_hash import content_hash
from storage.exchange.deleting.deletion import Deletion, purge, purge_keys, tombstoned_keys
from storage.exchange.deleting.unresolved import UnresolvedDeletion, unresolved_deletions
from storage.exchange.known_computers import KnownComputer, known_computers
from storage.exchange.lesson_merging import merge_lesson
from storage.exchange.merge_report import MergeReport
from storage.exchange.merging import merge
from storage.exchange.parquet import write_parquet
from storage.exchange.program_merging import merge_program
from storage.exchange.scope import ALL, Scope
from storage.file.backups import remove_from_backups
from storage.file.connection import Database
from storage.file.temporary import temporary_folder
from storage.sql import Stop, opened
from storage.text import new_id


class Exchange:
    """The exchange of one store with other files: export, merge, and deletion for good."""

    def __init__(self, database: Database, share: BackupShare) -> None:
        self._database = database
        self._share = share

    def export(
        self,
        dest: Path,
        *,
        app_version: str,
        computer: tuple[str, str],
        scope: Scope = ALL,
        is_recorded: bool = True,
        anonymous: Collection[str] | None = None,
    ) -> BundleInfo:
        """Writes a bundle; see `export_bundle`.

        Args:
            anonymous: if given, names and texts are left out, except these texts of worlds and activities that ship.
        """
        return export_bundle(
            self._database,
            dest,
            app_version=app_version,
            computer=computer if anonymous is None else (new_id(), "PC"),
            scope=scope,
            is_recorded=is_recorded,
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
        """Writes a folder of Parquet files; see `write_parquet`, and `export` for the arguments."""
        with temporary_folder() as folder:
            info = self.export(
                folder / "bundle",
                app_version=app_version,
                computer=computer,
                scope=scope,
                is_recorded=False,
                anonymous=anonymous,
            )
            with closing(opened(info.path, "rw")) as db:
                forget_unconfirmed(db)
            info = replace(info, path=write_parquet(info.path, dest))
        record_export(self._database, info, scope)
        return info

    def merge(
        self,
        path: Path,
        *,
        delete: bool = False,
        retained: Collection[str] = (),
        retain_newer: bool = True,
    ) -> MergeReport:
        """Merges a bundle into the store. The transaction is on disk when this returns.

        Args:
            delete: also deletes the rows that the bundle's tombstones name, from the store, the write-ahead log and
                the backups. Without it the report only counts them.
            retained: with `delete`, keys of groups and programs that are retained.
            retain_newer: with `delete`, also retains groups and programs that were moved to another class. Likewise
                groups and programs with work that the deleting PC did not have.

        Raises:
            StoreError: see `merging.merge`.
        """
        report = merge(
            self._database, path, delete=delete, retained=retained, retain_newer=retain_newer
        )
        if report.removed:
            self._database.checkpoint(waits_for_readers=True)
            report = replace(report, still_in=self._clean_copies(report.tombstones))
        return report

    def merge_program(self, path: Path) -> tuple[MergeReport, str]:
        """Adds the new rows of one program; see `program_merging.merge_program`."""
        return merge_program(self._database, path)

    def merge_lesson(self, path: Path) -> tuple[MergeReport, str]:
        """Adds the rows that a PC needs for a lesson; see `lesson_merging.merge_lesson`."""
        return merge_lesson(self._database, path)

    def known_computers(self) -> list[KnownComputer]:
        """Returns the PCs whose bundles were merged, the latest first."""
        return known_computers(self._database)

    def unresolved_deletions(self) -> list[UnresolvedDeletion]:
        """Returns deletions of other PCs that were neither confirmed nor refused here."""
        return unresolved_deletions(self._database)

    def purge(self, kind: str, *keys: str) -> Deletion:
        """Deletes rows of a kind for good, such as a `group`, also from the backups; see `deletion.purge`."""
        deletion = purge(self._database, kind, *keys)
        return replace(deletion, still_in=self._clean_copies(deletion.ids))

    def finish_removals(self, stop: Stop = lambda: False) -> tuple[Path, ...]:
        """Deletes tombstoned rows from the backups and the write-ahead log that still hold them.

        A deletion may have been interrupted, or a backup may have been locked or in the making.

        Returns:
            The backups that still hold such rows.
        """
        with self._database.read_connection() as db:
            ids = tombstoned_keys(db)
        if not ids:
            return ()
        self._database.checkpoint()
        left = self._clean_backups(ids, stop)
        self._share.resume()
        return left

    def _clean_copies(self, ids: Collection[str]) -> tuple[Path, ...]:
        """Cleans the backups here and in the shared folder; returns the files that may still hold the rows."""
        return self._clean_backups(ids) + self._share.clean()

    def _clean_backups(self, ids: Collection[str], stop: Stop = lambda: False) -> tuple[Path, ...]:
        return tuple(remove_from_backups(self._database.path, ids, purge_keys, stop))

    def content_hash(self) -> str:
        """Returns the content hash; stores with the same replicated rows have equal ones."""
        with self._database.read_connection() as db:
            return content_hash(db)
