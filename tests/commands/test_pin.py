"""`pinel pin` on the command line."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main
from pinel_desktop.errors import PinelError
from pinel_desktop.school.teacher import TeacherSessions
from storage import open_store


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PINEL_LANG", "en")


@pytest.fixture
def database(tmp_path: Path) -> Path:
    path = tmp_path / "pinel.db"
    with open_store(path) as store:
        TeacherSessions(store.settings).set_pin("1111")
    return path


def pin(database: Path, *arguments: str, typed: str = "") -> Result:
    return CliRunner().invoke(main, ["--db", str(database), "pin", *arguments], input=typed)


def opens(database: Path, digits: str) -> bool:
    with open_store(database) as store:
        try:
            TeacherSessions(store.settings).sign_in(digits)
        except PinelError:
            return False
        return True


def test_a_new_pin_takes_the_place_of_a_forgotten_one(database: Path) -> None:
    done = pin(database, typed="2718\n2718\n")
    assert done.exit_code == 0, done.output
    assert "The new PIN holds from now on." in done.output
    assert "2718" not in done.output
    assert (opens(database, "2718"), opens(database, "1111")) == (True, False)


def test_two_pins_that_differ_change_nothing(database: Path) -> None:
    done = pin(database, typed="2718\n2719\n")
    assert done.exit_code == 1
    assert "not the same" in done.stderr
    assert "Nothing has changed" in done.stderr
    assert opens(database, "1111")


def test_what_is_no_pin_is_said_before_it_is_asked_for_again(database: Path) -> None:
    done = pin(database, typed="12a4\n")
    assert done.exit_code == 1
    assert "4 to 12 digits" in done.stderr
    assert opens(database, "1111")


def test_forgetting_takes_it_away_and_says_what_that_means(database: Path) -> None:
    done = pin(database, "--forget")
    assert done.exit_code == 0, done.output
    assert "anybody can choose it" in done.output
    with open_store(database) as store:
        assert not TeacherSessions(store.settings).has_pin


def test_it_works_while_the_app_has_the_file_open(database: Path) -> None:
    with open_store(database) as store:
        sessions = TeacherSessions(store.settings)
        token = sessions.sign_in("1111")
        assert pin(database, typed="2718\n2718\n").exit_code == 0
        assert not sessions.is_signed_in(token)
        assert sessions.is_signed_in(sessions.sign_in("2718"))


def test_a_pin_may_come_before_the_first_start(tmp_path: Path) -> None:
    path = tmp_path / "new" / "pinel.db"
    assert pin(path, typed="2718\n2718\n").exit_code == 0
    assert opens(path, "2718")


def test_a_file_that_is_no_database_is_said_and_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "pinel.db"
    path.write_text("minhas notas", "utf-8")
    done = pin(path, typed="2718\n2718\n")
    assert done.exit_code == 1
    assert "Traceback" not in done.output
    assert path.read_text("utf-8") == "minhas notas"
