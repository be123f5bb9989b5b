"""`pinel doctor` on PCs with and without each component."""

import json
import os
from contextlib import closing
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main
from pinel_desktop.desktop.backends import NoWindowError, Pc
from pinel_desktop.desktop.self_check import RECORDED_SIGNS
from pinel_desktop.doctor import examination
from pinel_desktop.doctor.examination import HealthCheckResult
from pinel_desktop.messages import LANGUAGES, describe
from storage import open_store
from storage.exchange.backup_share import COPIES_BACKUPS, SHARED_FOLDER
from storage.file.backups import list_backups, make_backup
from storage.sqlite import sqlite3


def pc(*, screen: bool = True, gtk: str | None = None, browser: str | None = None) -> Pc:
    return Pc(
        platform="linux",
        environ={"DISPLAY": ":0"} if screen else {},
        which=lambda name: browser,
        is_file=lambda path: False,
        gtk_problem=lambda: gtk,
        qt_problem=lambda: "PyQt6",
    )


def window(this: Pc, problem: NoWindowError | None = None) -> list[tuple[str, str]]:
    """What is found where trying the native window ends with a problem, or with none."""
    found = examination._window(this, lambda toolkit: problem)
    return [(finding.level, finding.code) for finding in found]


def test_a_native_window_that_showed_a_page_is_all_that_is_said() -> None:
    assert window(pc(browser="/usr/bin/chromium")) == [("ok", "doctor_window_ok")]


def test_a_toolkit_that_loads_and_shows_nothing_is_not_called_a_window() -> None:
    problem = NoWindowError("doctor_window_silent", backend="gtk", seconds=30)
    assert window(pc(browser="/usr/bin/chromium"), problem) == [
        ("warn", "doctor_window_browser"),
        ("warn", "doctor_window_silent"),
        ("warn", "window_qt_missing"),
    ]


def test_a_browser_in_its_place_is_a_warning_with_the_reason() -> None:
    assert window(pc(gtk="no WebKit2", browser="/usr/bin/chromium")) == [
        ("warn", "doctor_window_browser"),
        ("warn", "window_gtk_missing"),
        ("warn", "window_qt_missing"),
    ]


def test_without_window_and_browser_every_way_out_is_said() -> None:
    codes = [code for _, code in window(pc(gtk="no WebKit2"))]
    assert codes == [
        "doctor_window_address",
        "window_gtk_missing",
        "window_qt_missing",
        "window_browser_missing",
    ]


def test_without_a_screen_the_page_can_still_be_served() -> None:
    assert window(pc(screen=False)) == [("warn", "doctor_window_none")]


def test_values_that_the_app_found_damaged_are_a_warning(tmp_path: Path) -> None:
    path = tmp_path / "pinel.db"
    open_store(path).close()
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("INSERT INTO content_sums VALUES ('runs', 'r', 'x', 'today')")
    finding = examination._database(path)
    assert (finding.code, finding.params["n_rows"]) == ("doctor_values_damaged", 1)


@pytest.mark.parametrize("version", ["3.40.1", "3.51.2"])
def test_a_sqlite_that_can_lose_a_write_is_told(version: str) -> None:
    finding = examination._sqlite(version)
    assert (finding.level, finding.code) == ("warn", "doctor_sqlite_old")


def test_the_sqlite_in_use_is_named() -> None:
    assert examination._sqlite("3.51.3").code == "doctor_sqlite_ok"
    assert examination._sqlite().params == {"version": sqlite3.sqlite_version}


def database(path: Path) -> tuple[str, str]:
    finding = examination._database(path)
    return finding.level, finding.code


def test_a_database_that_is_not_there_yet_is_no_fault(tmp_path: Path) -> None:
    assert database(tmp_path / "pinel.db") == ("ok", "doctor_database_new")
    assert not list(tmp_path.iterdir())


def test_a_sound_database_is_read_and_left_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "pinel.db"
    open_store(path).close()
    before = path.read_bytes()
    assert database(path) == ("ok", "doctor_database_ok")
    assert path.read_bytes() == before


def test_a_damaged_database_fails_with_what_will_happen_to_it(tmp_path: Path) -> None:
    path = tmp_path / "pinel.db"
    path.write_bytes(b"not a database, whatever its name says" * 100)
    assert database(path) == ("fail", "doctor_database_damaged")


def test_a_database_that_cannot_be_written_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "pinel.db"
    sqlite3.connect(path).close()
    # root may write to anything, so that the answer is given for an ordinary user
    monkeypatch.setattr(os, "access", lambda place, mode: mode != os.W_OK)
    path.write_bytes(b"")
    assert database(path) == ("fail", "doctor_database_read_only")


def test_what_pinel_would_not_open_is_told_as_it_will_be(tmp_path: Path) -> None:
    """A file of another program knows fewer saves than the mark, but it is no older copy; a pipe has no end."""
    path = tmp_path / "pinel.db"
    open_store(path).close()
    path.unlink()
    with closing(sqlite3.connect(path)) as others:
        others.execute("CREATE TABLE recipes (name TEXT)")
    assert database(path) == ("fail", "database_foreign")
    path.unlink()
    os.mkfifo(path)
    assert database(path) == ("fail", "database_foreign")


def test_rows_that_point_to_nothing_are_a_warning_with_their_number(tmp_path: Path) -> None:
    path = tmp_path / "pinel.db"
    open_store(path).close()
    with closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(
            "INSERT INTO programs (id, group_id, name, created_at, updated_at) VALUES ('p', 'x', '', '', '')"
        )
    finding = examination._database(path)
    assert (finding.level, finding.code) == ("warn", "doctor_database_inconsistent")
    assert finding.params["n_rows"] == 1


def test_an_index_that_lost_a_row_is_damage_which_a_quick_look_would_not_see(
    tmp_path: Path,
) -> None:
    path = tmp_path / "pinel.db"
    with closing(sqlite3.connect(path)) as connection:
        connection.executescript(
            """CREATE TABLE things (id INTEGER, name TEXT); CREATE INDEX names ON things (name);
               INSERT INTO things VALUES (1, 'a'); PRAGMA writable_schema = ON;
               UPDATE sqlite_master SET sql = 'CREATE INDEX names ON things (id)' WHERE name = 'names';"""
        )
    assert database(path) == ("fail", "doctor_database_damaged")


@pytest.fixture
def backed_up(tmp_path: Path) -> Path:
    """A database with two backups, the last from now."""
    path = tmp_path / "pinel.db"
    open_store(path).close()
    now = datetime.now(UTC)
    for made_at in (now - timedelta(days=30), now):
        make_backup(path, made_at)
    return path


def backups(path: Path) -> tuple[str, str]:
    finding = examination._backups(path)
    return finding.level, finding.code


def test_backups_are_counted_and_the_last_has_its_time(backed_up: Path) -> None:
    finding = examination._backups(backed_up)
    assert (finding.level, finding.code) == ("ok", "doctor_backups_ok")
    assert finding.params["n_backups"] == 2
    assert str(datetime.now().year) in str(finding.params["time"])


def test_no_backups_are_a_warning_once_there_is_something_to_lose(tmp_path: Path) -> None:
    assert backups(tmp_path / "pinel.db") == ("ok", "doctor_backups_none")
    (tmp_path / "pinel.db").touch()
    assert backups(tmp_path / "pinel.db") == ("warn", "doctor_backups_none")


def test_copies_in_the_shared_folder_are_told_with_the_time_of_the_newest(
    backed_up: Path, tmp_path: Path
) -> None:
    def found() -> tuple[str, str]:
        (finding,) = examination._copies(backed_up)
        return finding.level, finding.code

    assert found() == ("ok", "doctor_copies_off")
    with open_store(backed_up) as store:
        store.settings.set(SHARED_FOLDER, str(tmp_path / "rede"))
        store.settings.set(COPIES_BACKUPS, value=True)
        assert found() == ("warn", "doctor_copies_none")
        (tmp_path / "rede").mkdir()
        assert store.backup_share.update(20)
    assert found() == ("ok", "doctor_copies_ok")


def test_a_damaged_backup_is_named(backed_up: Path) -> None:
    newest = list_backups(backed_up)[0].path
    newest.write_bytes(b"rubbish" * 1000)
    assert backups(backed_up) == ("warn", "doctor_backups_bad")
    assert examination._backups(backed_up).params["name"] == newest.name


def test_backups_that_do_not_keep_up_with_the_work_are_a_warning_and_holidays_are_not(
    backed_up: Path,
) -> None:
    list_backups(backed_up)[0].path.unlink()
    assert backups(backed_up) == ("warn", "doctor_backups_old")
    month_ago = (datetime.now(UTC) - timedelta(days=30)).timestamp()
    os.utime(backed_up, (month_ago, month_ago))
    assert backups(backed_up) == ("ok", "doctor_backups_ok")


@pytest.mark.parametrize(
    ("free", "level"),
    [(80 * 10**9, "ok"), (500 * 10**6, "warn"), (20 * 10**6, "fail")],
    ids=["much", "little", "none"],
)
def test_free_space_is_judged_where_the_data_will_be(
    free: int, level: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[Path] = []

    def usage(folder: Path) -> Any:
        asked.append(folder)
        return type("Usage", (), {"free": free})

    monkeypatch.setattr("shutil.disk_usage", usage)
    (finding,) = examination._disk(tmp_path / "not" / "there" / "yet")
    assert (finding.level, asked) == (level, [tmp_path])


def test_sizes_are_whole_numbers_that_fit_every_language() -> None:
    sizes = (900, 25_000, 1_500_000_000, 83_400_000_000)
    assert [examination.size_text(size) for size in sizes] == [
        "900 B",
        "25 kB",
        "1500 MB",
        "83 GB",
    ]


def test_a_pc_without_a_camera_is_warned_about_signs_only(tmp_path: Path) -> None:
    signs, camera = examination._signs(tmp_path)
    assert (signs.level, camera.code) == ("ok", "doctor_camera_none")


def test_camera_that_gives_pictures_is_named(tmp_path: Path) -> None:
    (tmp_path / "video0").touch()
    _, camera = examination._signs(tmp_path, str(RECORDED_SIGNS))
    assert (camera.level, dict(camera.params)) == ("ok", {"devices": str(tmp_path / "video0")})


def test_camera_that_cannot_be_opened_is_told_with_the_reason(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(examination, "_CAMERA_TIMEOUT_S", 5.0)
    (tmp_path / "video0").touch()
    _, camera = examination._signs(tmp_path, "9")
    assert (camera.level, camera.code) == ("warn", "camera_missing")


def test_a_camera_of_others_is_told_apart_from_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "video0").touch()
    monkeypatch.setattr(os, "access", lambda place, mode: False)
    *_, camera = examination._signs(tmp_path)
    assert camera.code == "doctor_camera_closed"


def ros(folder: Path, *modules: str, **environ: str) -> HealthCheckResult:
    return examination._ros(environ, folder, lambda name: object() if name in modules else None)


def test_no_ros_is_no_fault(tmp_path: Path) -> None:
    assert ros(tmp_path).level == "ok"


def test_ros_of_this_terminal_is_named(tmp_path: Path) -> None:
    found = ros(tmp_path, "rclpy", "cyclonedds", ROS_DISTRO="jazzy")
    assert dict(found.params) == {"found": "ROS 2 jazzy, Cyclone DDS"}


def test_ros_that_was_not_sourced_comes_with_the_command(tmp_path: Path) -> None:
    (tmp_path / "jazzy").mkdir()
    (tmp_path / "jazzy" / "setup.bash").touch()
    found = ros(tmp_path)
    assert found.level == "warn"
    assert "setup.bash" in describe(found.code, found.params, "en").remedy


def run(home: Path, *arguments: str) -> Result:
    environment = {
        "PINEL_HOME": str(home),
        "PINEL_LANG": "en",
        "DISPLAY": "",
        "WAYLAND_DISPLAY": "",
    }
    return CliRunner().invoke(main, ["doctor", *arguments], env=environment)


def test_the_command_prints_one_object_about_everything(tmp_path: Path) -> None:
    result = run(tmp_path, "--json")
    found = json.loads(result.output)
    levels = {finding["about"]: finding["level"] for finding in found["findings"]}
    assert set(levels) == {
        "program",
        "page",
        "window",
        "engine",
        "disk",
        "database",
        "backups",
        "signs",
        "camera",
        "ros",
        "sqlite",
    }
    assert levels["engine"] == "ok"
    assert result.exit_code == (0 if found["ok"] else 1)


def test_the_command_speaks_in_words_and_writes_nothing(tmp_path: Path) -> None:
    result = run(tmp_path)
    assert result.output.startswith("PINEL Desktop 0.")
    assert "[ok] Simulator: ready" in result.output
    assert not list(tmp_path.iterdir())


def test_what_is_essential_decides_the_exit_status(tmp_path: Path) -> None:
    (tmp_path / "pinel.db").write_bytes(b"rubbish" * 1000)
    result = run(tmp_path)
    assert result.exit_code == 1
    assert "[failure] Database" in result.output
    assert "PINEL does not work like this" in result.output


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_word_of_the_doctor_exists_in_every_language(language: str) -> None:
    params = dict.fromkeys(
        [
            "version",
            "python",
            "system",
            "backend",
            "program",
            "devices",
            "user",
            "free",
            "folder",
            "size",
            "path",
        ],
        "x",
    ) | dict.fromkeys(
        ["problem", "found", "seconds", "n_rows", "n_backups", "time", "name", "n_saves", "files"],
        "x",
    )
    source = Path(examination.__file__).read_text("utf-8")
    codes = {
        token.strip("\"',)(")
        for token in source.replace("(", " ").split()
        if token.startswith('"doctor_')
    }
    assert len(codes) > 15
    for code in codes:
        text = describe(code, params, language)
        assert text.message != code
        assert "{" not in text.message + text.remedy
