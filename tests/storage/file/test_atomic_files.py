"""Files that get their name when they are complete, beside others that are there already."""

import errno
import os
from pathlib import Path

import pytest

from storage.file.atomic_files import atomic_create


def write(dest: Path, text: str) -> Path:
    with atomic_create(dest) as new:
        new.part.write_text(text, "utf-8")
    return new.final


def texts(folder: Path) -> dict[str, str]:
    return {file.name: file.read_text("utf-8") for file in folder.iterdir()}


@pytest.fixture(params=["links", "no links, as on FAT"])
def folder(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    def refuse(*_: object) -> None:
        raise OSError(errno.EPERM, os.strerror(errno.EPERM))

    if request.param != "links":
        monkeypatch.setattr("os.link", refuse)
    return tmp_path


def test_a_file_that_is_there_stays_and_the_new_one_gets_a_number(folder: Path) -> None:
    assert [write(folder / "a.pinel", text).name for text in "123"] == [
        "a.pinel",
        "a-2.pinel",
        "a-3.pinel",
    ]
    assert texts(folder) == {"a.pinel": "1", "a-2.pinel": "2", "a-3.pinel": "3"}


def test_a_failure_leaves_nothing(folder: Path) -> None:
    with pytest.raises(TypeError), atomic_create(folder / "a.pinel") as new:
        new.part.write_bytes("half")  # type: ignore[arg-type]
    assert texts(folder) == {}


def test_what_was_left_long_ago_goes_with_the_next_file_and_what_is_being_written_stays(
    folder: Path,
) -> None:
    left = [folder / ".b.pinel.part", folder / ".c.pinel.01234567.part"]
    for file in (*left, folder / ".d.pinel.89abcdef.part", folder / "e.pinel"):
        file.write_text("", "utf-8")
    for file in (*left, folder / "e.pinel"):
        os.utime(file, (0, 0))
    write(folder / "a.pinel", "1")
    assert sorted(texts(folder)) == [".d.pinel.89abcdef.part", "a.pinel", "e.pinel"]
