"""Merges a lesson file, which prepares a PC for a lesson. It may need no PIN, so it must hold no work of pupils."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from storage.errors import StoreError
from storage.exchange.bundle_reading import Bundle, open_bundle
from storage.exchange.merge_report import MergeReport
from storage.exchange.merging import merge_attached
from storage.file.connection import Database
from storage.limits import MAX_SAMPLES_WITHOUT_PIN

_OF_RUNS = ("runs", "notes", "truths")
_WORK = ("programs", "versions", *_OF_RUNS, "tombstones", "deletions", "former_classes")


def merge_lesson(database: Database, path: Path) -> tuple[MergeReport, str]:
    """Merges class, groups, lesson, preset, own activities and taught signs; returns the lesson's key too.

    Raises:
        StoreError: `bundle_not_lesson` if the file is of another kind; else as `merging.merge`.
    """
    with _opened(path) as (bundle, lesson_id):
        report = database.write(
            lambda db: merge_attached(db, bundle.info, database.now(), delete=False),
            attached=bundle.address,
        )
    return report, lesson_id


def check_lesson_file(path: Path) -> None:
    """Checks a file without merging it. Raises StoreError like `merge_lesson`."""
    with _opened(path):
        pass


@contextmanager
def _opened(path: Path) -> Iterator[tuple[Bundle, str]]:
    """Yields the bundle of a lesson file and the lesson's key."""
    with open_bundle(path, max_samples=MAX_SAMPLES_WITHOUT_PIN) as bundle:
        lesson_id = bundle.info.lesson_id
        if lesson_id is None or any(bundle.info.counts.get(table) for table in _WORK):
            raise StoreError("bundle_not_lesson", path=str(path))
        yield bundle, lesson_id
