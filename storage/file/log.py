"""The write-ahead log as it lies on disk: whether SQLite would leave out frames that belong to it.

SQLite reads a log up to the first frame whose checksum does not fit, and takes what follows for remains of earlier
rounds. Frames of the same round that follow are work that a wrong bit cuts off (sqlite.org/fileformat2.html#walformat).
"""

import struct
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from storage.side_files import read_regular

HEADER, FRAME_HEADER = 32, 24
WAL_MAGIC = 0x377F0682
PAGE = 4096  # SQLite's own size, which no release changes
_STEP = FRAME_HEADER + PAGE


def path_of(database: Path) -> Path:
    """Where the log of a database lies."""
    return database.with_name(f"{database.name}-wal")


def has_frames(database: Path) -> bool:
    """True where there is a log with content."""
    try:
        return path_of(database).stat().st_size > HEADER
    except OSError:
        return False


def lost_commits(database: Path) -> int:
    """Commits in the log that SQLite leaves out as something before them is damaged; 0 where all is well."""
    try:
        octets = read_regular(path_of(database))
    except OSError:
        return 0
    if len(octets) <= HEADER + FRAME_HEADER:
        return 0
    header = struct.unpack(">8I", octets[:HEADER])
    order = ">" if header[0] & 1 else "<"
    checksum = wal_checksum((0, 0), octets[:24], order)
    step = FRAME_HEADER + header[2]
    if header[0] & ~1 != WAL_MAGIC or checksum != header[6:] or not 512 <= header[2] <= 65536:
        return 1  # nothing of it is read
    return _commits_after_damage(octets, order, step, checksum, header[4:6])


def intact_frames(database: Path) -> Iterator[tuple[int, bytes]]:
    """Number and content of each page in the log that is as it was written, in their order, also after damage."""
    try:
        octets = read_regular(path_of(database))
    except OSError:
        return
    starts = range(HEADER, len(octets) - _STEP + 1, _STEP)
    salts = _salts(octets, starts)
    for start in starts:
        if octets[start + 8 : start + 16] == salts and _continues(octets, start):
            number = int.from_bytes(octets[start : start + 4], "big")
            yield number, octets[start + FRAME_HEADER : start + _STEP]


def _salts(octets: bytes, starts: range) -> bytes:
    """What marks frames of the present round: the header tells; where it is damaged, most frames do."""
    stored = struct.unpack_from(">2I", octets, 24) if starts else ()
    if any(wal_checksum((0, 0), octets[:24], order) == stored for order in "<>"):
        return octets[16:24]
    return Counter(octets[n + 8 : n + 16] for n in starts).most_common(1)[0][0] if starts else b""


def _continues(octets: bytes, start: int) -> bool:
    """Whether a frame's checksum continues that of the frame before it, of the first one that of the log's header."""
    before = start - _STEP + 16 if start > HEADER else HEADER - 8
    checksum: tuple[int, int] = struct.unpack_from(">2I", octets, before)
    counted = octets[start : start + 8] + octets[start + FRAME_HEADER : start + _STEP]
    stored = struct.unpack_from(">2I", octets, start + 16)
    return any(wal_checksum(checksum, counted, order) == stored for order in "<>")


def _commits_after_damage(
    octets: bytes, order: str, step: int, checksum: tuple[int, int], salts: tuple[int, ...]
) -> int:
    is_sound, n_commits = True, 0
    for start in range(HEADER, len(octets) - step + 1, step):
        _, n_pages, *rest = struct.unpack(">6I", octets[start : start + FRAME_HEADER])
        if tuple(rest[:2]) != salts and is_sound:
            return 0 if not _recurs(octets, start + step, step, salts) else 1
        if is_sound:
            checksum = wal_checksum(checksum, octets[start : start + 8], order)
            checksum = wal_checksum(checksum, octets[start + FRAME_HEADER : start + step], order)
            is_sound = checksum == tuple(rest[2:])
        if not is_sound:
            n_commits += bool(n_pages) and tuple(rest[:2]) == salts
    return n_commits


def _recurs(octets: bytes, begin: int, step: int, salts: tuple[int, ...]) -> bool:
    """Frames of this round come after one that seems to be of another: that one's salts are damaged."""
    return any(
        struct.unpack(">2I", octets[start + 8 : start + 16]) == salts
        for start in range(begin, len(octets) - step + 1, step)
    )


def wal_checksum(checksum: tuple[int, int], octets: bytes, order: str) -> tuple[int, int]:
    """The log's checksum of what came before, continued over more octets; `order`: of the words, as in struct."""
    one, other = checksum
    integers = struct.unpack(f"{order}{len(octets) // 4}I", octets)
    for first, second in zip(integers[::2], integers[1::2], strict=True):
        one = (one + first + other) & 0xFFFFFFFF
        other = (other + second + one) & 0xFFFFFFFF
    return one, other
