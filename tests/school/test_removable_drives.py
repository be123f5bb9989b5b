"""Removable drives and chosen folders, with their files."""

import os
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from pinel_desktop.school.removable_drives import folders

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="mount points")


def partition(mountpoint: str) -> SimpleNamespace:
    return SimpleNamespace(mountpoint=mountpoint, opts="rw,nosuid")


def test_a_folder_shows_its_files_and_those_of_its_folder_pinel(tmp_path: Path) -> None:
    (tmp_path / "PINEL").mkdir()
    for name, age in (("a.pinel", 30), ("PINEL/b.pinel", 10), ("c.txt", 0), ("PINEL/d.pinel", 20)):
        (tmp_path / name).write_text(name)
        os.utime(tmp_path / name, (1000 - age, 1000 - age))
    (tmp_path / "e.pinel").mkdir()
    (found,) = folders(".pinel", [tmp_path], partitions=list)
    assert [file.path.name for file in found.files] == ["b.pinel", "d.pinel", "a.pinel"]
    assert (found.is_removable, found.is_writable, found.name) == (False, True, tmp_path.name)
    assert found.free_bytes is not None
    assert found.files[0].size_bytes == len("PINEL/b.pinel")


def test_only_what_was_plugged_in_is_a_stick(tmp_path: Path) -> None:
    mounted = [partition("/"), partition("/media/no-such-stick"), partition("/boot")]
    assert folders(".pinel", partitions=lambda: mounted) == []


def test_a_folder_that_was_chosen_and_does_not_answer_is_told_as_such(tmp_path: Path) -> None:
    (found,) = folders(".pinel", [tmp_path / "gone"], partitions=list)
    assert (found.path, found.name) == (tmp_path / "gone", "gone")
    assert (found.is_reachable, found.is_writable, found.files) == (False, False, ())


def test_a_stick_is_found_where_desktops_put_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "pinel_desktop.school.removable_drives._MOUNT_POINTS", (f"{tmp_path.parent}/",)
    )
    (found,) = folders(".pinel", [tmp_path], partitions=lambda: [partition(str(tmp_path))])
    assert (found.is_removable, found.files) == (True, ())


def test_a_folder_that_cannot_be_read_shows_nothing(tmp_path: Path) -> None:
    (tmp_path / "PINEL").write_text("no folder")
    (found,) = folders(".pinel", [tmp_path], partitions=list)
    assert found.files == ()
