"""A group's day in a file, ways to damage the file, and what became of the edits that the group was told are saved."""

import os
import random
import shutil
import time
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import NamedTuple

from click.testing import CliRunner

from pinel_desktop.cli import main
from pinel_desktop.doctor import examination
from storage import Notice, Store, StoreError, open_store
from storage.file.backups import make_backup

PAGE = 4096


class Day(NamedTuple):
    """A file as the power cut left it, and the texts of its edits by their key.

    Attributes:
        n_backed_up: edits that are in the backup too.
    """

    path: Path
    edits: dict[str, str]
    n_backed_up: int


def a_day(folder: Path, *, n_edits: int = 270, n_backed_up: int = 150, n_in_log: int = 40) -> Day:
    """A file of edits, the last of them in its log, as it lies on the disk of a PC that was switched off."""
    at_work = folder / "at work" / "pinel.db"
    edits: dict[str, str] = {}
    with open_store(at_work) as store:
        program = store.programs.create(store.groups.create("A").id, "P")
        for n in range(n_edits):
            if n == n_backed_up:
                make_backup(at_work, datetime.now(UTC))
            if n == n_edits - n_in_log:
                store._database.checkpoint()
            text = f"{n} " + "x" * (n * 997 % 5000)
            edits[store.versions.save(program.id, {"text": text}, None).id] = text
        shutil.copytree(at_work.parent, folder / "left", ignore=shutil.ignore_patterns("*-shm"))
    return Day(folder / "left" / "pinel.db", edits, n_backed_up if n_backed_up < n_edits else 0)


def log_of(path: Path) -> Path:
    return path.with_name("pinel.db-wal")


def spoil(path: Path, start: int, n: int, seed: int = 1) -> None:
    """Overwrites bytes with chance."""
    octets = bytearray(path.read_bytes())
    octets[start : start + n] = random.Random(seed).randbytes(len(octets[start : start + n]))
    path.write_bytes(octets)


def reopened(day: Day) -> tuple[Notice | None, int]:
    """What is said when the file is opened, and how many of the edits are there as they were."""
    with open_store(day.path, close_interrupted=True) as store:
        return store.notice, n_stored(store, day.edits)


def n_stored(store: Store, edits: dict[str, str]) -> int:
    return sum(_is_stored(store, key, text) for key, text in edits.items())


def _is_stored(store: Store, key: str, text: str) -> bool:
    try:
        return store.versions.get(key).workspace == {"text": text}
    except Exception:
        return False


def code_of(found: tuple[Notice | None, int]) -> str | None:
    return found[0].code if found[0] else None


def doctor_code(day: Day) -> str:
    """What `pinel doctor` finds before the file is opened."""
    return examination._database(day.path).code


def pinel(*arguments: str | Path) -> int:
    """The exit status of a command."""
    return CliRunner().invoke(main, [str(argument) for argument in arguments]).exit_code


def wait_until(is_so: Callable[[], bool], timeout_s: float = 20.0) -> None:
    deadline = time.monotonic() + timeout_s
    while not is_so():
        assert time.monotonic() < deadline
        time.sleep(0.01)


def read_error(day: Day) -> str | None:
    """What is said of the first edit that cannot be shown, when somebody opens it."""
    with open_store(day.path) as store:
        for key in day.edits:
            try:
                store.versions.get(key)
            except StoreError as error:
                return error.code
    return None


class DamageOutcome(NamedTuple):
    """One damaged file of many: what was done, what was said, and how many of its edits are there as they were."""

    turn: int
    damage: str
    code: str | None
    n_retained: int
    n_edits: int
    n_reported: int  # edits that came back or were in the backup, and those that could not be read

    @property
    def is_honest(self) -> bool:
        """Nothing is lost, or it is said; and no fewer are there than the backup holds."""
        return self.n_retained == self.n_edits or self.code is not None


def outcome_of(turn: int, folder: Path) -> DamageOutcome:
    """Damages a file, in ways that depend on the number alone, and opens it."""
    chance = random.Random(turn)
    day = a_day(folder, n_edits=60, n_backed_up=chance.choice([30, 999]), n_in_log=20)
    methods = [_bits, _pages, _cut, _emptied, _removed]
    target = chance.choice([day.path, log_of(day.path)])
    method = methods[turn % len(methods)]
    method(target, chance)
    if chance.random() < 0.2:
        log_of(day.path).unlink(missing_ok=True)
    notice, n_retained = reopened(day)
    code = notice.code if notice else read_error(day)
    n_reported = (
        sum(int(str(notice.params.get(k) or 0)) for k in ("n_edits", "n_unread")) if notice else 0
    )
    return DamageOutcome(
        turn, f"{method.__name__} {target.name}", code, n_retained, len(day.edits), n_reported
    )


def _bits(file: Path, chance: random.Random) -> None:
    """Wrong bits in places that hold the file together: the header of a page, of a frame, of the file."""
    octets = bytearray(file.read_bytes())
    for _ in range(chance.randrange(1, 6)):
        page = chance.randrange(len(octets) // PAGE)
        octets[page * PAGE + chance.randrange(12)] ^= 1 << chance.randrange(8)
    file.write_bytes(octets)


def _pages(file: Path, chance: random.Random) -> None:
    for _ in range(chance.randrange(1, 6)):
        start = chance.randrange(file.stat().st_size // PAGE) * PAGE
        spoil(file, start, PAGE, chance.randrange(100))


def _cut(file: Path, chance: random.Random) -> None:
    os.truncate(file, chance.randrange(file.stat().st_size))


def _emptied(file: Path, _: random.Random) -> None:
    file.write_bytes(b"")


def _removed(file: Path, _: random.Random) -> None:
    file.unlink()
