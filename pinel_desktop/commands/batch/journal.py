"""Rows of an unfinished sweep: a file beside the table, to which each row is appended when its run is done.

The first line names the sweep; each further line is a row, as JSON. After a kill the last line may be torn: its run is
done again.
"""

import errno
import json
from contextlib import suppress
from dataclasses import fields
from pathlib import Path
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.sweep import Row

_HEAD = "pinel_sweep"
_FIELDS = frozenset(field.name for field in fields(Row))


class Journal:
    """The rows of one sweep on disk.

    Attributes:
        rows: the rows that are done, by index.

    Args:
        path: the file.
        sweep: fingerprint of everything that decides the rows.

    Raises:
        PinelError: `sweep_other`, if the file has rows of another sweep; `sweep_unwritable`.
    """

    def __init__(self, path: Path, sweep: str) -> None:
        self.path = path
        self.rows: dict[int, Row] = {}
        head = json.dumps({_HEAD: sweep}).encode() + b"\n"
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
                row = _row_from(json.loads(line))
                self.rows[row.index] = row

    def add(self, row: Row) -> None:
        """Appends a row. Raises PinelError `sweep_unwritable`."""
        plain = {name: value for name, value in row.as_plain().items() if name != "path"}
        try:
            self._append(json.dumps(plain, ensure_ascii=False).encode() + b"\n")
        except OSError as error:
            raise self._unwritable(error) from error
        self.rows[row.index] = row

    def _append(self, line: bytes) -> None:
        if self._file.write(line) != len(line):  # a disk that is nearly full takes a part
            raise OSError(errno.ENOSPC, "No space left on device")

    def _unwritable(self, error: OSError) -> PinelError:
        return unwritable(self.path, error)

    def close(self) -> None:
        """Closes the file; the rows stay for the next time."""
        self._file.close()

    def delete(self) -> None:
        """Deletes the file of a sweep whose table is complete."""
        self.close()
        self.path.unlink(missing_ok=True)


def unwritable(path: Path, error: OSError) -> PinelError:
    """Returns the problem of a file that cannot be written."""
    return PinelError("sweep_unwritable", path=str(path), problem=error.strerror or str(error))


def _row_from(plain: dict[str, Any]) -> Row:
    """Reads a row. Raises TypeError, ValueError if it is none."""
    if not isinstance(plain, dict) or plain.keys() | {"path"} != _FIELDS:
        raise ValueError("no row")
    end = plain["end"]
    return Row(**{**plain, "end": end and tuple(end)})
