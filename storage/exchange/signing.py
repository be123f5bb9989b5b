"""The PC's key pair, with which it signs its bundles (Ed25519), and what a signature covers.

The key lies in a file of its own beside the database: not in the database, so that no backup and no bundle holds it.
It belongs to the PC's key (`computers.this`): a data folder that was copied to another PC gets a new one there, as does
a folder whose key file is lost. The teacher then approves that PC again.

PyNaCl is imported when something is signed or read. Where a system has none, bundles are written without signature,
and count as such when read.
"""

import hashlib
import json
import os
import re
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from storage.side_files import read_regular
from storage.sql import column_names, row_count
from storage.sqlite import sqlite3
from storage.tables import rules
from storage.tables.replicated import REPLICATED
from storage.text import dumped

if TYPE_CHECKING:
    from nacl.signing import SigningKey

SIGNATURES, UNCONFIRMED = "signatures", "unconfirmed_runs"
_HEX = re.compile(r"[0-9a-f]{64}([0-9a-f]{64})?")
_LETTERS = "34679ACDEFGHJKMNPQRTVWXY"  # no two of them look alike
_GROUPS, _IN_GROUP = 3, 4


def key_path(database: Path) -> Path:
    """The file of the PC's key."""
    return database.with_name(f"{database.name}.key")


def fingerprint(public_key: str) -> str:
    """What people compare of a key: three groups of four letters and digits, 55 bits."""
    number = int.from_bytes(hashlib.sha256(bytes.fromhex(public_key)).digest(), "big")
    letters = ""
    for _ in range(_GROUPS * _IN_GROUP):
        number, place = divmod(number, len(_LETTERS))
        letters += _LETTERS[place]
    return "-".join(letters[at : at + _IN_GROUP] for at in range(0, len(letters), _IN_GROUP))


def own_public_key(database: Path, computer_id: str, *, make: bool = True) -> str | None:
    """The public key of this PC, in hex; None where it has none and, with `make`, none can be kept or used."""
    key = _own_key(database, computer_id, make=make)
    return None if key is None else bytes(key.verify_key).hex()


def sign(db: sqlite3.Connection, database: Path, computer_id: str) -> str | None:
    """Signs a bundle that is finished but for that; returns the public key, None where this PC has no key to use."""
    key = _own_key(database, computer_id, make=True)
    if key is None or not _is_covered(db):
        return None
    public_key = bytes(key.verify_key).hex()
    signature = key.sign(_text(db, public_key)).signature.hex()
    db.execute(
        f"INSERT INTO {SIGNATURES} (public_key, signature) VALUES (?, ?)", [public_key, signature]
    )
    return public_key


def signer(db: sqlite3.Connection) -> str | None:
    """The public key with which a bundle is signed; None for one without signature.

    Raises:
        ValueError: the signature is not of this content, or what it covers is not as PINEL writes it.
    """
    if not column_names(db, SIGNATURES):  # of a release that did not sign
        return None
    marks = db.execute(f"SELECT run_id, public_key FROM {UNCONFIRMED}")
    if not all(rules.key(run) and (key is None or _is_hex(key, 64)) for run, key in marks):
        raise ValueError(UNCONFIRMED)
    rows = db.execute(f"SELECT public_key, signature FROM {SIGNATURES} LIMIT 2").fetchall()
    if not rows:
        return None
    public_key, signature = rows[0]
    if len(rows) > 1 or not _is_hex(public_key, 64) or not _is_hex(signature, 128):
        raise ValueError(SIGNATURES)
    return _verified(db, public_key, signature)


def _verified(db: sqlite3.Connection, public_key: str, signature: str) -> str | None:
    try:
        from nacl.exceptions import BadSignatureError  # noqa: PLC0415 - see above
        from nacl.signing import VerifyKey  # noqa: PLC0415
    except ImportError:
        return None
    try:
        text = _text(db, public_key)
        VerifyKey(bytes.fromhex(public_key)).verify(text, bytes.fromhex(signature))
    except BadSignatureError:
        raise ValueError("signature") from None
    if not _is_covered(db):
        raise ValueError("rows that no signature covers")
    return public_key


def _text(db: sqlite3.Connection, public_key: str) -> bytes:
    """What is signed: all that the bundle says of itself, the checksum of its rows among it, and its marks."""
    names = column_names(db, "bundle")
    return dumped(
        [
            "PINEL bundle",
            public_key,
            db.execute("PRAGMA application_id").fetchone()[0],
            list(zip(names, db.execute("SELECT * FROM bundle").fetchone(), strict=True)),
            [tuple(row) for row in db.execute(f"SELECT * FROM {UNCONFIRMED} ORDER BY run_id")],
        ]
    ).encode()


def _is_covered(db: sqlite3.Connection) -> bool:
    """Whether the checksum counts every row: it leaves out runs that have not ended, and PCs without work."""
    return not any(
        row_count(db, table.name, f"NOT ({table.condition.format(schema='main')})")
        for table in REPLICATED
        if column_names(db, table.name)
    )


def _own_key(database: Path, computer_id: str, *, make: bool) -> "SigningKey | None":
    try:
        from nacl.signing import SigningKey  # noqa: PLC0415 - see above
    except ImportError:
        return None
    path = key_path(database)
    seed = _kept_seed(path, computer_id)
    if seed is None and make:
        seed = bytes(SigningKey.generate())
        if not _keep(path, {"computer_id": computer_id, "seed": seed.hex()}):
            return None
    return None if seed is None else SigningKey(seed)


def _kept_seed(path: Path, computer_id: str) -> bytes | None:
    """None where there is no file, one that is damaged, or that of another PC whose folder was copied."""
    try:
        kept = json.loads(read_regular(path))
        seed = kept["seed"]
        return (
            bytes.fromhex(seed)
            if kept["computer_id"] == computer_id and _is_hex(seed, 64)
            else None
        )
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        return None


def _keep(path: Path, content: dict[str, str]) -> bool:
    """Writes the file, which its owner alone may read; False where the folder takes none."""
    part = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        with suppress(FileNotFoundError):
            part.unlink()
        handle = os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(json.dumps(content))
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
    except OSError:
        return False
    return True


def _is_hex(text: object, length: int) -> bool:
    return isinstance(text, str) and len(text) == length and _HEX.fullmatch(text) is not None
