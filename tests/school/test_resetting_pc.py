"""A PC whose disk is as before after each start: said before work is lost, and the group takes its work along."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from pinel_desktop import app_database
from pinel_desktop.app import App
from pinel_desktop.app_database import open_database
from pinel_desktop.doctor import examination
from pinel_desktop.settings import RESETS, Settings
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

SQUARE = {"pinel_ir": 1, "name": "square", "functions": [], "commands": []}
# the folder for the layers must not be a layer itself
_MOUNTS = {
    "home in memory": "mount -t tmpfs tmpfs {home}",
    "disk that is reset": (
        "mount -t tmpfs tmpfs {layers} && mkdir {layers}/up {layers}/work {layers}/image &&"
        " mount -t overlay overlay -o lowerdir={layers}/image,upperdir={layers}/up,workdir={layers}/work {home}"
    ),
}


def notice_of(database: Path) -> str | None:
    with open_database(database) as store:
        assert store.writable
        return store.notice.code if store.notice else None


@pytest.mark.skipif(sys.platform != "linux", reason="mounts of Linux")
@pytest.mark.parametrize("mount", _MOUNTS.values(), ids=_MOUNTS)
def test_a_folder_that_is_lost_at_the_end_is_reported(mount: str, tmp_path: Path) -> None:
    if os.geteuid():
        pytest.skip("only root may mount")
    home, layers = tmp_path / "home", tmp_path / "layers"
    home.mkdir()
    layers.mkdir()
    code = "; ".join(
        [
            "from pinel_desktop.app_database import open_database",
            "from pinel_desktop.paths import database_path",
            "print(open_database(database_path()).notice.code)",
        ]
    )
    environment = os.environ | {"XDG_DATA_HOME": str(home)}
    environment.pop("PINEL_HOME", None)
    script = f'{mount.format(home=home, layers=layers)} && exec "$0" -c "$1"'
    done = subprocess.run(
        ["unshare", "--mount", "sh", "-c", script, sys.executable, code],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout.split() == ["database_not_lasting"], done.stderr


def test_a_pc_of_which_the_technician_said_so_is_reported_where_its_work_is_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setattr(app_database, "is_in_memory", lambda folder: False)
    places = tmp_path / "pinel" / "pinel.db", tmp_path / "elsewhere" / "pinel.db"
    for database in places:
        database.parent.mkdir()
        assert notice_of(database) is None
        Settings.beside(database).choose(RESETS, "1")
    assert [notice_of(database) for database in places] == ["database_not_lasting", None]
    said = [[one.code for one in examination._forgetful_disk(database)] for database in places]
    assert said == [["doctor_disk_not_lasting"], []]


def test_a_chosen_folder_in_memory_is_reported_unless_it_is_for_temporary_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "home"))  # has the list of locations
    monkeypatch.setattr(app_database, "is_in_memory", lambda folder: True)
    assert notice_of(tmp_path / "pinel.db") is None
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "temporary"))
    assert notice_of(tmp_path / "pinel.db") == "database_not_lasting"


@contextmanager
def pc(folder: Path) -> Iterator[Browser]:
    folder.mkdir(exist_ok=True)
    with App(folder / "pinel.db", make_engine=FakeEngine) as app:
        yield Browser.signed_in(app.address)


def test_a_group_takes_all_its_work_along_and_goes_on_after_the_reset(tmp_path: Path) -> None:
    with pc(tmp_path / "monday") as browser:
        group, other = (
            browser.post("/api/groups", {"name": name}).data for name in ("Onças", "Araras")
        )
        for owner, name in ((group, "Um"), (group, "Dois"), (other, "Outro")):
            made = browser.post(f"/api/groups/{owner['id']}/programs", {"name": name}).data
            content = {"workspace": {}, "document": SQUARE}
            browser.post(f"/api/programs/{made['id']}/versions", content)
        octets = browser.get(f"/api/groups/{group['id']}/file").body
        assert browser.get(f"/api/groups/{'0' * 36}/file").status in (404, 422)
    with pc(tmp_path / "friday") as browser:
        headers = {"Content-Type": "application/octet-stream"}
        path = "/api/programs/file?name=grupo.pinel"
        brought = browser.send("POST", path, body=octets, headers=headers).data
        assert brought["group_id"] == group["id"]
        (found,) = browser.get("/api/groups").data["groups"]
        assert found["name"] == "Onças"
        programs = browser.get(f"/api/groups/{group['id']}/programs").data["programs"]
        assert sorted(one["name"] for one in programs) == ["Dois", "Um"]
        assert brought["program_id"] == next(one["id"] for one in programs if one["name"] == "Dois")
