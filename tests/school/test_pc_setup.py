"""`pinel setup`: one file sets up every PC of a school."""

from pathlib import Path

import pytest

from pinel_desktop.app import App
from pinel_desktop.commands import serve
from pinel_desktop.commands.pc import first_start, for_all
from pinel_desktop.errors import PinelError
from pinel_desktop.school.pc_setup import PcSetupError, read_pc_setup
from pinel_desktop.school.robot_profiles import RobotProfiles
from pinel_desktop.school.teacher import TeacherSessions, pin_hash, stored_pin
from pinel_desktop.settings import CAMERA, LANGUAGE, RESETS, Settings
from storage import Store, open_store
from storage.exchange.backup_share import COPIES_BACKUPS, SHARED_FOLDER
from storage.exchange.scope import Scope
from tests.commands.typed import pinel

WHOLE = """
language = "fr"
camera = 1
theme = "contrast"

school = "EE Viçosa"
class = "9º A"
level = 2
swap_minutes = 10

shared_folder = "/media/escola"
copies_of_backups = true
pin_hash = "{pin_hash}"
kiosk = true
resets_at_reboot = true

[robot.dds]
domain = 5
max_v_mps = 0.2
"""


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PINEL_LANG", "en")


def written(folder: Path, text: str) -> Path:
    file = folder / "pinel.toml"
    file.write_text(text, "utf-8")
    return file


def set_up(folder: Path, text: str, name: str = "pc") -> Path:
    """Sets up a PC; returns its database."""
    database = folder / name / "pinel.db"
    done = pinel("--db", str(database), "setup", str(written(folder, text)))
    assert done.exit_code == 0, done.output
    return database


def faults(folder: Path, text: str) -> list[tuple[str, object]]:
    """Code and line of each fault."""
    with pytest.raises(PcSetupError) as caught:
        read_pc_setup(written(folder, text))
    return [(fault.code, fault.params["line"]) for fault in caught.value.faults]


def test_everything_that_the_file_names_is_set(tmp_path: Path) -> None:
    database = set_up(tmp_path, WHOLE.format(pin_hash=pin_hash("2718")))
    settings = Settings.beside(database)
    assert (settings[LANGUAGE], settings[CAMERA]) == ("fr", "1")
    assert settings.opens_kiosk
    assert settings[RESETS] == "1"
    with open_store(database) as store:
        (classroom,) = store.classrooms.all()
        assert classroom.name == "9º A"
        assert settings["pinel_class"] == classroom.id
        assert store.class_presets.get(classroom.id) == {"level": 2, "swap_minutes": 10}
        assert store.settings.get(SHARED_FOLDER) == "/media/escola"
        assert store.settings.get(COPIES_BACKUPS) is True
        profile = RobotProfiles(store.settings, ("dds",)).profile("dds")
        assert (profile.address, profile.max_v_mps) == ("domain 5 cmd_vel", 0.2)
        sessions = TeacherSessions(store.settings)
        with pytest.raises(PinelError, match="pin_wrong"):
            sessions.sign_in("2719")
        assert sessions.sign_in("2718")


def test_what_the_file_does_not_name_stays(tmp_path: Path) -> None:
    database = set_up(tmp_path, WHOLE.format(pin_hash=pin_hash("2718")))
    set_up(tmp_path, 'class = "9º A"\nlevel = 3')
    with open_store(database) as store:
        (classroom,) = store.classrooms.all()
        assert store.class_presets.get(classroom.id) == {"level": 3, "swap_minutes": 10}
        assert TeacherSessions(store.settings).sign_in("2718")
    assert Settings.beside(database)[LANGUAGE] == "fr"


def test_the_class_of_two_pcs_is_one_class_after_a_merge(tmp_path: Path) -> None:
    text = 'school = "EE Viçosa"\nclass = "9º A"'
    first, second = set_up(tmp_path, text, "first"), set_up(tmp_path, text, "second")
    with open_store(second) as store:
        (classroom,) = store.classrooms.all()
        group = store.groups.create("Os Tatus", classroom_id=classroom.id)
        _export(store, tmp_path / "second.pinel", Scope())
    with open_store(first) as store:
        store.exchange.merge(tmp_path / "second.pinel")
        assert [row.id for row in store.classrooms.all()] == [classroom.id]
        assert store.groups.get(group.id).classroom_id == classroom.id


def test_classes_of_two_schools_are_two(tmp_path: Path) -> None:
    keys = set()
    for name in ("EE Viçosa", "EE Ponte Nova"):
        with open_store(set_up(tmp_path, f'school = "{name}"\nclass = "9º A"', name)) as store:
            keys |= {row.id for row in store.classrooms.all()}
    assert len(keys) == 2


@pytest.fixture
def lesson_file(tmp_path: Path) -> Path:
    with open_store(tmp_path / "teacher.db") as store:
        classroom = store.classrooms.create("8º B")
        lesson = store.lessons.open(classroom.id, "Aula 1")
        _export(store, tmp_path / "aula.pinel", Scope(classroom.id, lesson_id=lesson.id))
    return tmp_path / "aula.pinel"


def test_the_lesson_file_beside_it_is_opened(tmp_path: Path, lesson_file: Path) -> None:
    database = set_up(tmp_path, f'lesson = "{lesson_file.name}"')
    with open_store(database) as store:
        (classroom,) = store.classrooms.all()
        (lesson,) = store.lessons.of_classroom(classroom.id)
        assert (classroom.name, lesson.title) == ("8º B", "Aula 1")
    assert Settings.beside(database)["pinel_class"] == classroom.id


def _export(store: Store, file: Path, scope: Scope) -> None:
    computer = store.computers.this()
    store.exchange.export(file, app_version="0.2.0", computer=computer, scope=scope)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('language = "pt-BR"\nclass = "9º A', [("pc_setup_syntax", 2)]),
        ('\nlanguge = "fr"', [("pc_setup_unknown", 2)]),
        ('language = "xx"', [("pc_setup_value", 1)]),
        ("language = 3", [("pc_setup_value", 1)]),
        ('theme = ""', [("pc_setup_value", 1)]),
        ("camera = 10", [("pc_setup_value", 1)]),
        ("camera = true", [("pc_setup_value", 1)]),
        ('class = "9º A"\nlevel = 4', [("pc_setup_value", 2)]),
        ('class = "9º A"\nlevel = "2"', [("pc_setup_value", 2)]),
        ("level = 2\nclass = 9", [("pc_setup_needs_class", 1), ("pc_setup_value", 2)]),
        ("level = 2", [("pc_setup_needs_class", 1)]),
        ('class = "9º A"\nkiosk = true', [("pc_setup_needs_pin", 2)]),
        ("kiosk = 1", [("pc_setup_value", 1)]),
        ('class = "  "', [("pc_setup_value", 1)]),
        ("shared_folder = false", [("pc_setup_value", 1)]),
        ('copies_of_backups = "yes"', [("pc_setup_value", 1)]),
        ('pin_hash = "2718"', [("pc_setup_value", 1)]),
        ('lesson = "away.pinel"', [("pc_setup_entry", 1)]),
        ("[robot.dds]\ndomain = 500", [("pc_setup_entry", 1)]),
        ("[robot.dds.room]\nwidth_m = 2\nx_m = 20", [("pc_setup_entry", 1)]),
        ("\n[robot.legs]\nlegs = 6", [("pc_setup_value", 2)]),
        ("robot = 3", [("pc_setup_value", 1)]),
        ("level = 9\nlevel = 9", [("pc_setup_syntax", 2)]),
    ],
)
def test_a_fault_names_its_line(
    text: str, expected: list[tuple[str, object]], tmp_path: Path
) -> None:
    assert faults(tmp_path, text) == expected


def test_all_faults_are_printed_and_nothing_is_changed(tmp_path: Path) -> None:
    database = tmp_path / "pc" / "pinel.db"
    file = written(tmp_path, 'language = "fr"\nlevel = 9\nclass = "9º A"\nteacher = "Ana"')
    done = pinel("--db", str(database), "setup", str(file))
    assert done.exit_code == 1
    assert "Line 2: level cannot be 9. It can be: 1, 2, 3." in done.stderr
    assert "Line 4: “teacher” does not exist in a set-up file." in done.stderr
    assert not database.parent.exists()


def test_a_file_that_is_away_or_no_file_is_named(tmp_path: Path) -> None:
    for path in (tmp_path / "away.toml", tmp_path):
        done = pinel("setup", str(path))
        assert done.exit_code == 1
        assert str(path) in done.stderr


def test_a_file_that_is_no_lesson_is_found_by_a_check(tmp_path: Path) -> None:
    (tmp_path / "aula.pinel").write_bytes(b"no bundle" * 1000)
    assert faults(tmp_path, 'lesson = "aula.pinel"') == [("pc_setup_entry", 1)]


def test_a_check_changes_nothing(tmp_path: Path) -> None:
    database = tmp_path / "pc" / "pinel.db"
    done = pinel("--db", str(database), "setup", "--check", str(written(tmp_path, "camera = 0")))
    assert done.exit_code == 0
    assert "Nothing was changed." in done.output
    assert not database.exists()


def test_two_hashes_of_a_pin_are_different() -> None:
    assert stored_pin(pin_hash("2718")) != stored_pin(pin_hash("2718"))


@pytest.mark.parametrize(
    "text",
    ["", "2718", "scrypt:1:8:1:00:00", "scrypt:16384:8:1:zz:00", "scrypt:16384:8:1::", 3, None],
)
def test_another_text_is_no_hash_of_a_pin(text: object) -> None:
    assert stored_pin(text) is None


def test_the_command_prints_the_line_of_the_file(tmp_path: Path) -> None:
    done = pinel("pin", "--hash", text="2718\n2718\n")
    assert done.exit_code == 0
    line = done.output.splitlines()[-1]
    read = read_pc_setup(written(tmp_path, line))
    assert read.pin is not None


@pytest.fixture
def file_of_pc(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    file = tmp_path / "etc" / "pinel.toml"
    file.parent.mkdir()
    monkeypatch.setattr(first_start, "SETUP_FILE", file)
    return file


def test_each_system_has_one_place_for_the_file() -> None:
    file = first_start.setup_file_path("win32", "/programs/PINEL/pinel-desktop.exe")
    assert file == Path("/programs/PINEL/setup/pinel.toml")
    assert first_start.setup_file_path("linux") == Path("/etc/pinel/pinel.toml")


def test_the_first_start_of_an_account_is_set_up_and_no_later_one(
    file_of_pc: Path, tmp_path: Path
) -> None:
    database = tmp_path / "home" / "pinel.db"
    file_of_pc.write_text('language = "fr"', "utf-8")
    first_start.set_up_if_new(database)
    assert Settings.beside(database)[LANGUAGE] == "fr"
    file_of_pc.write_text('language = "es"', "utf-8")
    first_start.set_up_if_new(database)
    assert Settings.beside(database)[LANGUAGE] == "fr"


def test_the_first_start_without_a_window_is_set_up_too(
    file_of_pc: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    database = tmp_path / "home" / "pinel.db"
    file_of_pc.write_text('language = "fr"', "utf-8")
    served: list[str] = []
    monkeypatch.setattr(serve, "_serve", lambda app, choice: _begin(app, served))
    assert pinel("--db", str(database), "serve").exit_code == 0
    assert served == ["fr"]


def _begin(app: App, served: list[str]) -> None:
    with app:
        served.append(app.language)


def test_a_wrong_file_is_named_and_keeps_nobody_from_starting(
    file_of_pc: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file_of_pc.write_text("level = 9", "utf-8")
    first_start.set_up_if_new(tmp_path / "home" / "pinel.db")
    assert "Line 1: level cannot be 9." in capsys.readouterr().err
    assert not (tmp_path / "home").exists()


def test_a_missing_stick_is_not_replaced_by_a_new_database(
    file_of_pc: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(first_start, "is_location_missing", lambda database: True)
    file_of_pc.write_text('language = "fr"', "utf-8")
    first_start.set_up_if_new(tmp_path / "stick" / "pinel.db")
    assert not (tmp_path / "stick").exists()


@pytest.fixture
def autostart(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    file = tmp_path / "autostart" / "pinel-desktop.desktop"
    monkeypatch.setattr(for_all, "AUTOSTART", file)
    return file


def test_a_file_for_every_account_is_copied_with_its_lesson(
    file_of_pc: Path, autostart: Path, lesson_file: Path
) -> None:
    text = f'lesson = "{lesson_file.name}"\nat_login = true'
    for _ in range(2):
        assert pinel("setup", "--system", str(written(lesson_file.parent, text))).exit_code == 0
    assert file_of_pc.read_text("utf-8") == text
    assert (file_of_pc.parent / lesson_file.name).read_bytes() == lesson_file.read_bytes()
    assert file_of_pc.stat().st_mode & 0o777 == 0o644
    assert "Exec=pinel" in autostart.read_text("utf-8")
    assert (
        pinel("setup", "--system", str(written(lesson_file.parent, "at_login = false"))).exit_code
        == 0
    )
    assert not autostart.exists()


def test_without_the_right_to_write_the_place_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    no_folder = tmp_path / "file"
    no_folder.write_text("", "utf-8")
    monkeypatch.setattr(first_start, "SETUP_FILE", no_folder / "pinel.toml")
    done = pinel("setup", "--system", str(written(tmp_path, "level = 2\nclass = '9º A'")))
    assert done.exit_code == 1
    assert str(no_folder) in done.output
