"""The write-ahead log (WAL) on disk: finds frames that belong to it but that SQLite would ignore.

SQLite reads a log up to the first frame whose checksum does not match. It takes all later frames for remains from
before the last reset of the log. If later frames have the current salts, they are commits that a wrong bit has cut
off (sqlite.org/fileformat2.html#walformat).
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
    """Returns the path of a database's log."""
    return database.with_name(f"{database.name}-wal")


def has_frames(database: Path) -> bool:
    """Returns True if there is a log with content."""
    try:
        return path_of(database).stat().st_size > HEADER
    except OSError:
        return False


def lost_commits(database: Path) -> int:
    """Returns how many commits in the log SQLite ignores because of damage before them; 0 for none."""
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
        return 1  # SQLite reads no frame of it
    return _commits_after_damage(octets, order, step, checksum, header[4:6])


def intact_frames(database: Path) -> Iterator[tuple[int, bytes]]:
    """Yields number and content of each intact page in the log, in order, also after damage."""
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
    """Returns the current salts: from an intact header, else the salts of most frames."""
    stored = struct.unpack_from(">2I", octets, 24) if starts else ()
    if any(wal_checksum((0, 0), octets[:24], order) == stored for order in "<>"):
        return octets[16:24]
    return Counter(octets[n + 8 : n + 16] for n in starts).most_common(1)[0][0] if starts else b""


def _continues(octets: bytes, start: int) -> bool:
    """Returns whether the frame's checksum continues the checksum of the frame, or header, before it."""
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
    """Returns True if frames with the current salts follow a frame with others, whose salts are damaged then."""
    return any(
        struct.unpack(">2I", octets[start + 8 : start + 16]) == salts
        for start in range(begin, len(octets) - step + 1, step)
    )


def wal_checksum(checksum: tuple[int, int], octets: bytes, order: str) -> tuple[int, int]:
    """Continues the log's checksum over more octets; `order` is the byte order of the words, as in struct."""
    one, other = checksum
    integers = struct.unpack(f"{order}{len(octets) // 4}I", octets)
    for first, second in zip(integers[::2], integers[1::2], strict=True):
        one = (one + first + other) & 0xFFFFFFFF
        other = (other + second + one) & 0xFFFFFFFF
    return one, other
