"""Rows of unfinished work on many runs: a file beside the result, to which each row is appended when its run is done.

The first line names the work; each further line is a row, as JSON. After a kill the last line may be torn: its run is
done again.
"""

import errno
import json
from collections.abc import Callable
from contextlib import suppress
from dataclasses import fields
from pathlib import Path
from typing import Any, Generic, TypeVar

from pinel_desktop.errors import PinelError
from pinel_desktop.sweep import Row

_HEAD = "pinel_sweep"
_FIELDS = frozenset(field.name for field in fields(Row))

Key = TypeVar("Key")
Done = TypeVar("Done")


class Journal(Generic[Key, Done]):
    """The rows of one work on disk.

    Attributes:
        rows: the rows that are done, by key.

    Args:
        path: the file.
        fingerprint: of everything that decides the rows.
        read: returns key and row of a line; raises TypeError, ValueError if it is none.

    Raises:
        PinelError: `sweep_other`, if the file has rows of other work; `sweep_unwritable`.
    """

    def __init__(
        self, path: Path, fingerprint: str, read: Callable[[Any], tuple[Key, Done]]
    ) -> None:
        self.path = path
        self.rows: dict[Key, Done] = {}
        self._row_of = read
        head = json.dumps({_HEAD: fingerprint}).encode() + b"\n"
        try:
            content = path.read_bytes() if path.exists() else b""
            if not content.startswith(head) and not head.startswith(content):
                raise PinelError("sweep_other", path=str(path))
            whole = content[: content.rfind(b"\n") + 1]
            self._read(whole.splitlines()[1:])
            self._file = path.open("r+b" if path.exists() else "x+b", buffering=0)
            self._file.truncate(len(whole))
            self._file.seek(0, 2)
            if not whole:
                self._append(head)
        except OSError as error:
            raise self._unwritable(error) from error

    def _read(self, lines: list[bytes]) -> None:
        for line in lines:
            with suppress(
                ValueError, TypeError
            ):  # a line that a disk has damaged: its run is done again
                key, row = self._row_of(json.loads(line))
                self.rows[key] = row

    def add(self, plain: Any) -> None:
        """Appends a row as plain data. Raises PinelError `sweep_unwritable`."""
        try:
            self._append(json.dumps(plain, ensure_ascii=False).encode() + b"\n")
        except OSError as error:
            raise self._unwritable(error) from error
        key, row = self._row_of(plain)
        self.rows[key] = row

    def _append(self, line: bytes) -> None:
        if self._file.write(line) != len(line):  # a disk that is nearly full takes a part
            raise OSError(errno.ENOSPC, "No space left on device")

    def _unwritable(self, error: OSError) -> PinelError:
        return unwritable(self.path, error)

    def close(self) -> None:
        """Closes the file; the rows stay for the next time."""
        self._file.close()

    def delete(self) -> None:
        """Deletes the file of work whose result is complete."""
        self.close()
        self.path.unlink(missing_ok=True)


def unwritable(path: Path, error: OSError) -> PinelError:
    """Returns the problem of a file that cannot be written."""
    return PinelError("sweep_unwritable", path=str(path), problem=error.strerror or str(error))


def sweep_journal(out: Path, fingerprint: str) -> Journal[int, Row]:
    """Returns the journal of a sweep, beside its table. Raises what `Journal` raises."""
    return Journal(journal_path(out), fingerprint, _row_from)


def journal_path(out: Path) -> Path:
    """Returns the journal of a result."""
    return out.with_name(f"{out.name}.rows")


def plain_of(row: Row) -> dict[str, Any]:
    """Returns the line of a row: all but its path."""
    return {name: value for name, value in row.as_plain().items() if name != "path"}


def _row_from(plain: dict[str, Any]) -> tuple[int, Row]:
    if not isinstance(plain, dict) or plain.keys() | {"path"} != _FIELDS:
        raise ValueError("no row")
    end = plain["end"]
    return plain["index"], Row(**{**plain, "end": end and tuple(end)})
