"""Power cuts while the WAL or the file is being written: files as a disk may hold them afterwards.

A commit is in the file when all its frames are whole in the WAL (SQLite's file format, section 4): frames end where
the WAL ends, or where a checksum does not hold. So of edits that were saved one after the other, those before that
place must be there, all of them, and no other.
"""

import os
import random
import shutil
import struct
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

import pytest

from storage import open_store
from storage.sqlite import sqlite3

HEADER, FRAME_HEADER = 32, 24
N_MOMENTS, N_CUTS = 6, 20


@dataclass(frozen=True)
class Log:
    """A WAL, read as the file format says, with its own reading of which frames are valid."""

    content: bytes

    @property
    def frame_size(self) -> int:
        return FRAME_HEADER + int(struct.unpack(">I", self.content[8:12])[0])

    def frames(self) -> Iterator[tuple[int, int, int]]:
        """Offset, page number and size of the file after the commit (0 within one) of this generation's frames."""
        salts = self.content[16:24]
        for offset in range(HEADER, len(self.content) - self.frame_size + 1, self.frame_size):
            page, size = struct.unpack(">II", self.content[offset : offset + 8])
            if (
                self.content[offset + 8 : offset + 16] != salts
            ):  # left over from before a checkpoint
                return
            yield offset, page, size

    @property
    def end(self) -> int:
        """Where the last commit ends."""
        ends = [offset + self.frame_size for offset, _, size in self.frames() if size]
        return max(ends, default=0)


@dataclass(frozen=True)
class LogSnapshot:
    """What lay on the disk when `len(saved)` edits had been acknowledged, and where in the WAL each ends."""

    folder: Path
    saved: tuple[str, ...]
    ends: tuple[int, ...]
    log: Log

    def expected(self, whole_until: int) -> list[str]:
        """The edits whose commits lie before a place in the WAL; 0 for those that are in the file itself."""
        return [text for text, end in zip(self.saved, self.ends, strict=True) if end <= whole_until]


def log_of(path: Path) -> Log:
    return Log(path.with_name(path.name + "-wal").read_bytes())


def generation(log: Log) -> bytes:
    return log.content[16:24]


def n_frames_in_file(path: Path) -> int:
    """How much of the WAL a checkpoint has brought into the file; by then all of it is safely on disk."""
    index = path.with_name(path.name + "-shm").read_bytes()
    return int(struct.unpack("=I", index[96:100])[0])


@pytest.fixture
def seed() -> int:
    """Printed, so that a failure can be had again."""
    seed = random.SystemRandom().randrange(2**32)
    print(f"\nseed {seed}")
    return seed


@pytest.fixture
def chance(seed: int) -> random.Random:
    return random.Random(seed)


@pytest.fixture
def moments(tmp_path: Path, chance: random.Random) -> list[LogSnapshot]:
    """Copies of a file and its WAL while a group edits, at random moments over several checkpoints."""
    path = tmp_path / "work" / "pinel.db"
    found: list[LogSnapshot] = []
    saved: list[str] = []
    ends: list[int] = []
    with open_store(path) as store:
        program = store.programs.create(store.groups.create("A").id, "P")
    with open_store(path) as store:
        store.settings.set("language", "es")
        before = generation(log_of(path))
        while len(found) < N_MOMENTS or len({generation(moment.log) for moment in found}) < 2:
            text = f"{len(saved)} " + "x" * chance.randrange(30_000)
            store.versions.save(program.id, {"text": text}, None)
            log = log_of(path)
            if generation(log) != before:  # a checkpoint has brought all before it into the file
                before, ends = generation(log), [0] * len(saved)
            saved.append(text)
            ends.append(log.end)
            if chance.random() < 0.02 and not n_frames_in_file(path):
                folder = tmp_path / f"moment {len(found)}"
                shutil.copytree(path.parent, folder)
                found.append(LogSnapshot(folder, tuple(saved), tuple(ends), log))
    return found


def edits_after_power_cut(
    moment: LogSnapshot, folder: Path, spoil: Callable[[Path], None] = lambda wal: None
) -> tuple[list[str], str | None]:
    """What is there when a copy of the moment with a spoilt WAL is opened: in order, the file being whole. And what is
    said."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(moment.folder, folder)
    path = folder / "pinel.db"
    path.with_name("pinel.db-shm").unlink(missing_ok=True)  # memory, gone with the power
    spoil(path.with_name("pinel.db-wal"))
    with open_store(path, close_interrupted=True) as store:
        code = store.notice.code if store.notice else None
        (group,) = store.groups.all()
        (program,) = store.programs.of_group(group.id)
        store.versions.save(program.id, {"text": "goes on"}, None)
    with closing(sqlite3.connect(path)) as db:
        assert db.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        assert db.execute("PRAGMA foreign_key_check").fetchall() == []
        rows = db.execute(
            "SELECT json_extract(workspace, '$.text') FROM versions ORDER BY number"
        ).fetchall()
    texts = [text for (text,) in rows]
    assert texts.pop() == "goes on"
    return texts, code


def test_a_log_that_is_whole_gives_back_every_edit(
    moments: list[LogSnapshot], tmp_path: Path
) -> None:
    for moment in moments:
        assert edits_after_power_cut(moment, tmp_path / "cut") == (list(moment.saved), None)


def test_a_log_cut_at_any_byte_holds_exactly_the_edits_before_the_cut(
    moments: list[LogSnapshot], tmp_path: Path, chance: random.Random
) -> None:
    n_lost = 0
    for moment in moments:
        for _ in range(N_CUTS):
            size = chance.randrange(moment.log.end + 1)

            def spoil(wal: Path, size: int = size) -> None:
                os.truncate(wal, size)

            recovered, notice_code = edits_after_power_cut(moment, tmp_path / "cut", spoil)
            assert recovered == moment.expected(size), f"cut at {size}"
            assert (notice_code == "database_earlier") == (len(recovered) < len(moment.saved))
            n_lost += len(moment.saved) - len(recovered)
    assert n_lost > 0


@pytest.mark.parametrize("n_flips", [3, pytest.param(N_CUTS, marks=pytest.mark.nightly)])
def test_a_log_with_a_flipped_byte_holds_the_edits_before_it_and_gives_back_those_after_it(
    moments: list[LogSnapshot], tmp_path: Path, chance: random.Random, n_flips: int
) -> None:
    for moment in moments:
        for _ in range(n_flips):
            place = chance.randrange(moment.log.end)
            flip = chance.randrange(1, 256)

            def spoil(wal: Path, place: int = place, flip: int = flip) -> None:
                content = bytearray(wal.read_bytes())
                content[place] ^= flip
                wal.write_bytes(content)

            frame = (place - HEADER) // moment.log.frame_size
            whole = HEADER + frame * moment.log.frame_size if place >= HEADER else 0
            recovered, notice_code = edits_after_power_cut(moment, tmp_path / "cut", spoil)
            about = f"byte {place} of the WAL ^ {flip}"
            assert set(moment.expected(whole)) <= set(recovered) <= set(moment.saved), about
            assert len(recovered) >= len(moment.saved) - 2, (
                about
            )  # of the frame, and of the one before it
            assert notice_code is not None or recovered == list(moment.saved), about


def test_a_checkpoint_that_was_cut_off_anywhere_loses_nothing(
    moments: list[LogSnapshot], tmp_path: Path, chance: random.Random
) -> None:
    """The WAL is emptied only when all its pages are in the file: until then any of them may be there, also in part."""
    for moment in moments:
        for _ in range(3):

            def spoil(wal: Path, moment: LogSnapshot = moment) -> None:
                with wal.with_name("pinel.db").open("r+b") as file:
                    for page, content in pages_of(moment.log).items():
                        if chance.random() < 0.5:
                            file.seek((page - 1) * len(content))
                            file.write(content[: chance.choice([512, 1000, len(content)])])

            assert edits_after_power_cut(moment, tmp_path / "cut", spoil) == (
                list(moment.saved),
                None,
            )


def pages_of(log: Log) -> dict[int, bytes]:
    """The newest content of each page, as a checkpoint writes it."""
    whole = [frame for frame in log.frames() if frame[0] < log.end]
    start = FRAME_HEADER
    return {
        page: log.content[offset + start : offset + log.frame_size] for offset, page, _ in whole
    }
