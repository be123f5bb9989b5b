"""The table of attacks, continued: the folder with the work is away. It reads as `test_attacks.py` does."""

import os
import shutil
from pathlib import Path

import pytest

from pinel_desktop.database_locations import forget_location, is_location_missing, record_location
from pinel_desktop.doctor import examination
from pinel_desktop.paths import database_path, default_folder
from tests.attacks.damage import pinel
from tests.attacks.disks import served
from tests.commands.typed import SQUARE

pytestmark = pytest.mark.waits


@pytest.fixture
def stick(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder that is no temporary one for PINEL, and an account that has not used PINEL."""
    (tmp_path / "temporary").mkdir()
    monkeypatch.setenv("TMPDIR", str(tmp_path / "temporary"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "share"))
    return tmp_path / "media" / "stick"


def used(stick: Path) -> Path:
    """A file with work, of an app that was closed."""
    path = stick / "pinel.db"
    with served(path) as app:
        assert app.database["notice"] is None or app.database["writable"]
        app.browser.post("/api/groups", {"name": "Onças"})
        assert app.end() == 0
    return path


@pytest.mark.parametrize("how", ["away", "a mount point without its disk"])
def test_a_folder_that_is_away_is_named_and_nothing_is_begun_in_its_place(
    stick: Path, tmp_path: Path, how: str
) -> None:
    path = used(stick)
    stick.rename(tmp_path / "pulled")
    if how != "away":
        stick.mkdir()
    assert examination._database(path).code == "database_place_missing"
    assert pinel("--db", path, "export", tmp_path) == 1
    assert pinel("--db", path, "run", SQUARE) == 0  # it drives, and says that it records nothing
    with served(path) as app:
        notice = app.database["notice"]
        assert (notice["code"], app.database["writable"]) == ("database_place_missing", False)
        assert str(stick) in notice["details"]
        refused = app.browser.post("/api/groups", {"name": "A"})
        assert (refused.status, refused.error["code"]) == (503, "database_place_missing")
        assert app.end() == 0
        assert str(stick) in app.output
    assert not stick.exists() or list(stick.iterdir()) == []
    shutil.rmtree(stick, ignore_errors=True)
    (tmp_path / "pulled").rename(stick)
    with served(path) as app:
        assert app.groups == ["Onças"]


def test_who_wants_to_begin_with_nothing_says_so_and_does(stick: Path) -> None:
    path = used(stick)
    shutil.rmtree(stick)
    with served(path) as app:
        answer = app.browser.post("/api/database/begin-empty", {}).data
        assert answer["database"]["notice"]["code"] == "database_begins_empty"
        app.end()
    with served(path) as app:
        assert (app.groups, app.database["writable"]) == ([], True)
        assert app.browser.post("/api/groups", {"name": "A"}).status == 200
        refused = app.browser.post("/api/database/begin-empty", {})
        assert refused.error["code"] == "database_not_missing"


def test_of_a_folder_that_is_there_what_is_missing_is_told_as_ever(stick: Path) -> None:
    path = used(stick)
    path.unlink()
    with served(path) as app:
        assert app.database["notice"]["code"].startswith("database_gone")


def test_places_are_remembered_once_and_up_to_a_number(stick: Path) -> None:
    for n in range(30):
        record_location(stick / f"{n}" / "pinel.db")
        record_location(stick / "pinel.db")
    assert is_location_missing(stick / "pinel.db")
    assert is_location_missing(stick / "29" / "pinel.db")
    assert not is_location_missing(stick / "2" / "pinel.db")
    forget_location(stick / "pinel.db")
    assert not is_location_missing(stick / "pinel.db")


def test_what_lies_in_the_place_of_the_list_keeps_nothing_from_working(stick: Path) -> None:
    default_folder().mkdir(parents=True)
    os.mkfifo(default_folder() / "places.json")
    record_location(stick / "pinel.db")
    assert is_location_missing(stick / "pinel.db")  # it was replaced
    (default_folder() / "places.json").write_text('{"a": 1}', "utf-8")
    assert not is_location_missing(stick / "pinel.db")


def test_neither_pinel_s_own_folder_nor_a_temporary_one_is_noted(
    stick: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PINEL_HOME", raising=False)
    record_location(database_path())
    record_location(tmp_path / "temporary" / "x" / "pinel.db")
    assert not default_folder().exists()
