"""Signs that a class taught: recordings of hands that show them, at rest or in motion.

A recording is one row that never changes, so the union of the rows of two PCs is their merge. For each sign the newest
samples of each kind count. Names that differ in case only are the same sign.
"""

import unicodedata
from collections.abc import Iterable
from dataclasses import replace

from storage.errors import StoreError
from storage.file.repository import Repository
from storage.limits import MAX_SIGN, MAX_TAUGHT_SAMPLES, MAX_TAUGHT_SIGNS, N_FEATURES
from storage.row_types import SignSamples
from storage.sql import insert, not_found, require, rows_of
from storage.sqlite import sqlite3
from storage.text import clean_name, name_key, natural_key, new_id

_SAMPLE_BYTES = 2 * N_FEATURES


class TaughtSigns(Repository):
    """The taught signs of the file."""

    def of_classroom(self, classroom_id: str) -> list[SignSamples]:
        """Returns the signs of a class by name, each with its newest samples.

        Raises:
            StoreError: `classroom_not_found`.
        """
        with self._database.read_connection() as db:
            require(db, "classrooms", classroom_id)
            return _signs(_sample_rows(db, classroom_id))

    def name_to_teach(self, classroom_id: str, name: str, *, is_moving: bool = False) -> str:
        """Returns how the class spells the sign of that name, which may be new.

        Args:
            is_moving: a movement will be taught.

        Raises:
            StoreError: `classroom_not_found`; `sign_name_wrong`; `sign_taught_enough` if it has enough samples;
                `signs_too_many`.
        """
        clean, taught = _clean(name), self.of_classroom(classroom_id)
        known = next((one for one in taught if name_key(one.sign) == name_key(clean)), None)
        if known is None and len(taught) >= MAX_TAUGHT_SIGNS:
            raise StoreError("signs_too_many", max=MAX_TAUGHT_SIGNS)
        if known:
            n_samples = known.n_movements if is_moving else known.n_samples
            if n_samples >= MAX_TAUGHT_SAMPLES:
                raise StoreError("sign_taught_enough", sign=known.sign)
        return known.sign if known else clean

    def add(self, classroom_id: str, sign: str, samples: bytes, *, is_moving: bool = False) -> None:
        """Adds a recording.

        Args:
            samples: at most `MAX_TAUGHT_SAMPLES` rows of `N_FEATURES` finite float16, little-endian.
            is_moving: whether they are movements.

        Raises:
            StoreError: as `name_to_teach`.
        """
        name = self.name_to_teach(classroom_id, sign, is_moving=is_moving)
        row: dict[str, object] = {"id": new_id(), "classroom_id": classroom_id, "sign": name}
        row |= {"created_at": self._database.now(), "samples": samples, "is_moving": is_moving}

        def write(db: sqlite3.Connection) -> None:
            require(db, "classrooms", classroom_id)
            insert(db, "taught_signs", row)

        self._database.write(write)

    def keys(self, classroom_id: str, sign: str) -> list[str]:
        """Returns the keys of all recordings of a sign.

        Raises:
            StoreError: `classroom_not_found`, `taught_sign_not_found`.
        """
        with self._database.read_connection() as db:
            require(db, "classrooms", classroom_id)
            rows = _sample_rows(db, classroom_id)
        found = [str(row["id"]) for row in rows if name_key(row["sign"]) == name_key(sign)]
        if not found:
            raise not_found("taught_signs", sign)
        return found


def _sample_rows(db: sqlite3.Connection, classroom_id: str) -> list[sqlite3.Row]:
    """Returns the recordings, newest first, without damaged ones."""
    query = """SELECT id, sign, samples, is_moving FROM taught_signs
        WHERE classroom_id = ? ORDER BY id DESC"""
    found = rows_of(db, query, [classroom_id])
    return [row for row in found if _is_readable(row)]


def _is_readable(row: sqlite3.Row) -> bool:
    from storage.tables.rules import hands, sign  # noqa: PLC0415 - the start needs no validation rules

    return sign(row["sign"]) and hands(row["samples"])


def _signs(recordings: Iterable[sqlite3.Row]) -> list[SignSamples]:
    by_key: dict[str, SignSamples] = {}
    for row in recordings:
        key = name_key(row["sign"])
        newer = by_key.get(key, SignSamples(row["sign"]))
        field = "movements" if row["is_moving"] else "samples"
        combined = (getattr(newer, field) + row["samples"])[: MAX_TAUGHT_SAMPLES * _SAMPLE_BYTES]
        by_key[key] = replace(newer, **{field: combined}, sign=row["sign"])
    # a merge may bring more signs than one PC records
    in_order = sorted(by_key, key=lambda key: (natural_key(key), key))
    return [by_key[key] for key in in_order[:MAX_TAUGHT_SIGNS]]


def _clean(name: str) -> str:
    """Returns a name that can be part of a URL. A single letter becomes the capital that programs compare with."""
    from storage.tables.rules import sign  # noqa: PLC0415 - the start needs no validation rules

    clean = unicodedata.normalize("NFC", clean_name(name))
    clean = clean.upper() if len(clean) == 1 else clean
    if not sign(clean):
        raise StoreError("sign_name_wrong", name=clean, max=MAX_SIGN)
    return clean
