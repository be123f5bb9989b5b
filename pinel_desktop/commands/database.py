"""The database as commands use it that write to it, also while the app has it open."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pinel_desktop.commands.failure import Failure
from pinel_desktop.errors import PinelError
from storage import Store, StoreError, open_for_reading, open_store


@contextmanager
def opened_store(path: Path, *, may_be_new: bool) -> Iterator[Store]:
    """The store of a file that is as it should be; what goes wrong with it is told in words.

    A damaged file is not touched: the app, when it opens it, sets it aside and says so.
    """
    try:
        if path.is_file() and path.stat().st_size:
            _look_at(path)
        elif not may_be_new:
            raise PinelError("database_missing", path=str(path))
        with open_store(path) as store:
            yield store
    except (PinelError, StoreError) as error:
        raise Failure(error) from error


def _look_at(path: Path) -> None:
    try:
        open_for_reading(path).close()
    except StoreError as error:
        if error.code != "database_older":
            raise
