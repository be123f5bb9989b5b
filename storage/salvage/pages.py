"""The pages of a damaged file and of its write-ahead log, without SQLite, which refuses such files.

The layout is that of sqlite.org/fileformat2.html. Nothing in the file is trusted: each number may be wrong.
"""

import mmap
import struct
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Self

from storage.file.log import FRAME_HEADER, HEADER, WAL_MAGIC, summed

_MAGIC = b"SQLite format 3\0"
_USUAL = 4096
_MOST_PAGES = 2**31


class Pages:
    """Pages by number, each with all its states that are left, the newest first.

    Args:
        file: the damaged file; it may be missing.
        wal: its write-ahead log; it may be missing.
    """

    def __init__(self, file: Path, wal: Path) -> None:
        self._octets, self._wal = _mapped(file), _mapped(wal)
        self.size = _page_size(self._octets[:20], self._wal[:HEADER])
        n_reserved = self._octets[20] if self._octets[:16] == _MAGIC else 0
        self.usable = self.size - (n_reserved if n_reserved <= self.size - 480 else 0)
        magic = int.from_bytes(self._wal[:4], "big")
        self._orders = {WAL_MAGIC: "<", WAL_MAGIC | 1: ">"}.get(magic, "<>")
        self._frames: dict[int, list[int]] = {}
        self._earlier_frames: dict[
            int, list[int]
        ] = {}  # of rounds that are in the file, if it is there
        self._find_frames()

    def close(self) -> None:
        """Lets go of the files, which can be renamed then."""
        for mapped in (self._octets, self._wal):
            if isinstance(mapped, mmap.mmap):
                mapped.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self.close()

    def numbers(self) -> Iterator[int]:
        """Every page of which there is a state, in order."""
        in_file = range(1, -(-len(self._octets) // self.size) + 1)
        yield from in_file
        in_log = self._frames.keys() | self._earlier_frames.keys()
        yield from sorted(number for number in in_log if number not in in_file)

    def states(self, number: int) -> Iterator[bytes]:
        """The states of a page, the newest first; none where there is no such page."""
        for place in reversed(self._frames.get(number, ())):
            yield self._wal[place : place + self.size]
        start = (number - 1) * self.size
        if 0 <= start < len(self._octets):
            yield self._octets[start : start + self.size].ljust(self.size, b"\0")
        for place in reversed(self._earlier_frames.get(number, ())):
            yield self._wal[place : place + self.size]

    def newest(self, number: int) -> bytes:
        """The newest state of a page, empty where there is none."""
        return next(self.states(number), b"")

    def _find_frames(self) -> None:
        """Frames of the log's present round have the salts of the first. A damaged one is left out."""
        step, salts = FRAME_HEADER + self.size, None
        for start in range(HEADER, len(self._wal) - step + 1, step):
            number, _, *now = struct.unpack(">4I", self._wal[start : start + 16])
            salts = salts or now
            if 0 < number < _MOST_PAGES and self._is_sound(start, step):
                frames = self._frames if now == salts else self._earlier_frames
                frames.setdefault(number, []).append(start + FRAME_HEADER)

    def _is_sound(self, start: int, step: int) -> bool:
        """Each frame's checksum continues that of the frame before, the first one's that of the log's header."""
        before = start - step + 16 if start > HEADER else HEADER - 8
        sums: tuple[int, int] = struct.unpack(">2I", self._wal[before : before + 8])
        page = self._wal[start + FRAME_HEADER : start + step]
        stored = struct.unpack(">2I", self._wal[start + 16 : start + 24])
        for order in self._orders:
            if summed(summed(sums, self._wal[start : start + 8], order), page, order) == stored:
                return True
        return start == HEADER  # the header may be what is damaged


def _mapped(path: Path) -> bytes | mmap.mmap:
    """The octets of a file, read when they are looked at; none of a file that is missing or empty."""
    with suppress(OSError, ValueError), path.open("rb") as file:
        return mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
    return b""


def _page_size(file: bytes, wal: bytes) -> int:
    """As the header of the file or of its log says it; else the usual one."""
    said = []
    if file[:16] == _MAGIC:
        said.append(int.from_bytes(file[16:18], "big"))
    said.append(int.from_bytes(wal[8:12], "big"))
    sizes = (65536 if size == 1 else size for size in said)
    return next((s for s in sizes if 512 <= s <= 65536 and s & (s - 1) == 0), _USUAL)
