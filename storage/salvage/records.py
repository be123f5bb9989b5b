"""Rows out of pages: the cells of a leaf page, and the values of a cell (sqlite.org/fileformat2.html)."""

import struct
from collections.abc import Iterator
from typing import NamedTuple

from storage.limits import MAX_VALUE
from storage.salvage.pages import Pages

TABLE_LEAF, TABLE_INTERIOR, INDEX_LEAF, INDEX_INTERIOR = 13, 5, 10, 2
_MOST_PAYLOAD = 4 * MAX_VALUE
Values = tuple[object, ...]


class Cell(NamedTuple):
    """One cell of a page; `values` is None where it cannot be read."""

    rowid: int
    values: Values | None


class Damage(Exception):  # noqa: N818 - what was met, not a fault of the program
    """What lies here is no cell."""


def kind_of(page: bytes, number: int) -> int:
    """The kind of a page: `TABLE_LEAF` and so on; another number for one that holds no cells."""
    start = 100 if number == 1 else 0
    return page[start] if len(page) > start else 0


def cells(pages: Pages, page: bytes, number: int) -> Iterator[Cell]:
    """The cells of a leaf page, or of an interior page of an index, in their order."""
    kind = kind_of(page, number)
    for place in _places(page, number, 12 if kind == INDEX_INTERIOR else 8):
        yield _cell(pages, page, place + (4 if kind == INDEX_INTERIOR else 0), kind == TABLE_LEAF)


def children(page: bytes, number: int) -> Iterator[int]:
    """Numbers of the pages below an interior page."""
    for place in _places(page, number, 12):
        yield int.from_bytes(page[place : place + 4], "big")
    start = 100 if number == 1 else 0
    yield int.from_bytes(page[start + 8 : start + 12], "big")


def _places(page: bytes, number: int, header: int) -> Iterator[int]:
    start = 100 if number == 1 else 0
    n_cells = int.from_bytes(page[start + 3 : start + 5], "big")
    for n in range(min(n_cells, (len(page) - start - header) // 2)):
        at = start + header + 2 * n
        yield int.from_bytes(page[at : at + 2], "big")


def _cell(pages: Pages, page: bytes, place: int, is_table: bool) -> Cell:
    rowid = 0
    try:
        size, place = _varint(page, place)
        if is_table:
            rowid, place = _varint(page, place)
        return Cell(rowid, _values(_payload(pages, page, place, size, is_table)))
    except (Damage, IndexError, struct.error, UnicodeDecodeError):
        return Cell(rowid, None)


def _payload(pages: Pages, page: bytes, place: int, size: int, is_table: bool) -> bytes:
    usable = pages.usable
    most = usable - 35 if is_table else (usable - 12) * 64 // 255 - 23
    if not 0 < size <= _MOST_PAYLOAD:
        raise Damage
    if size <= most:
        return _part(page, place, size)
    least = (usable - 12) * 32 // 255 - 23
    local = least + (size - least) % (usable - 4)
    local = local if local <= most else least
    parts, n_left = [_part(page, place, local)], size - local
    following = int.from_bytes(_part(page, place + local, 4), "big")
    while n_left > 0:
        overflow = pages.newest(following)
        n_here = min(n_left, usable - 4)
        parts.append(_part(overflow, 4, n_here))
        following, n_left = int.from_bytes(overflow[:4], "big"), n_left - n_here
    return b"".join(parts)


def _part(octets: bytes, start: int, size: int) -> bytes:
    part = octets[start : start + size]
    if len(part) != size:
        raise Damage
    return part


def _values(payload: bytes) -> Values:
    end, place = _varint(payload, 0)
    kinds = []
    while place < end:
        kind, place = _varint(payload, place)
        kinds.append(kind)
    if place != end:
        raise Damage
    values = []
    for kind in kinds:
        size = _size_of(kind)
        values.append(_value(kind, _part(payload, place, size)))
        place += size
    if place != len(payload):
        raise Damage
    return tuple(values)


def _size_of(kind: int) -> int:
    if kind < 12:
        return (0, 1, 2, 3, 4, 6, 8, 8, 0, 0, -1, -1)[kind]
    return (kind - 12) // 2


def _value(kind: int, octets: bytes) -> object:
    if kind >= 12:
        return octets.decode() if kind % 2 else octets
    if kind == 7:
        return struct.unpack(">d", octets)[0]
    if kind in (8, 9):
        return kind - 8
    if kind > 9:
        raise Damage
    return int.from_bytes(octets, "big", signed=True) if kind else None


def _varint(octets: bytes, place: int) -> tuple[int, int]:
    """A number of 1 to 9 bytes, and the place after it."""
    value = 0
    for n in range(8):
        octet = octets[place + n]
        value = value << 7 | octet & 127
        if octet < 128:
            return value, place + n + 1
    value = value << 8 | octets[place + 8]
    return value - (1 << 64 if value >> 63 else 0), place + 9
