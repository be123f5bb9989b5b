"""The file with which a person has opened PINEL, such as by a double click.

The teacher's part offers it; nothing of it is used before the teacher merges it.
"""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import FileOpened
from storage import StoreError

if TYPE_CHECKING:  # imported when a file is examined, not at the app's start
    from pinel_desktop.school.removable_drives import ExchangeFile

# what the command line puts in the place of bytes that are no text
_NO_TEXT = "\ufffd"


class OpenedFile:
    """The file that the teacher's part offers to merge; `path` is None without one."""

    def __init__(self, publish: Callable[[dict[str, Any]], None], path: str | None = None) -> None:
        self._publish = publish
        self.path = Path(path) if path else None
        self._is_new = True

    def choose(self, path: str) -> None:
        """Offers another file, and leads all pages to it."""
        self.path, self._is_new = Path(path), True
        self._publish(FileOpened().to_wire())

    def news(self) -> list[dict[str, Any]]:
        """Returns what leads a page that connects only now to the file, once: pages may be loading at the start."""
        is_new, self._is_new = self._is_new, False
        return [FileOpened().to_wire()] if is_new and self.path else []

    def forget(self, path: Path) -> None:
        """Ends the offer of a file."""
        if self.path == path:
            self.path = None


def examined(path: Path) -> "ExchangeFile":
    """Returns size and time of a file that may be a bundle. Reads its head only.

    Raises:
        PinelError: `opened_file_name`, `opened_file_irregular` if it is a link, a pipe, a device or a folder.
        StoreError: as `bundle_reading.check_head`.
    """
    from pinel_desktop.school.removable_drives import ExchangeFile  # noqa: PLC0415 - see above
    from storage.exchange.bundle_reading import check_head  # noqa: PLC0415

    if _NO_TEXT in path.name:
        raise PinelError("opened_file_name", path=path.name)
    try:
        if path.is_symlink() or (path.exists() and not path.is_file()):
            raise PinelError("opened_file_irregular", path=path.name)
        check_head(path)
        about = path.stat()
    except OSError as error:
        raise StoreError("bundle_unreadable", path=str(path), problem=error.strerror) from error
    return ExchangeFile(path, about.st_size, about.st_mtime)
