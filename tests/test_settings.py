"""What was chosen on this PC outlives window and app."""

import json
from pathlib import Path

import pytest

from pinel_desktop.app import App
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.settings import SETTINGS, Settings
from storage import open_store
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine


def test_settings_are_there_when_the_app_starts_again(tmp_path: Path) -> None:
    database = tmp_path / "pinel.db"
    settings = Settings.beside(database)
    settings.choose("pinel_theme", "dark")
    settings.choose("pinel_turns", "5")
    settings.choose("pinel_turns", "10")
    again = Settings.beside(database)
    assert again.chosen == {"pinel_theme": "dark", "pinel_turns": "10"}
    again.choose("pinel_theme", "")
    assert Settings.beside(database).chosen == {"pinel_turns": "10"}
    assert [file.name for file in tmp_path.iterdir()] == ["pinel.db.page.json"]


def test_what_a_newer_release_has_stored_stays_in_the_file(tmp_path: Path) -> None:
    file = tmp_path / "pinel.db.page.json"
    newer = {"pinel_next": ["x"], "pinel_language": "it", "pinel_theme": "dark"}
    file.write_text(json.dumps(newer), "utf-8")
    settings = Settings(file)
    assert settings.chosen == {"pinel_theme": "dark"}
    settings.choose("pinel_theme", "light")
    assert json.loads(file.read_text("utf-8")) == newer | {"pinel_theme": "light"}


def test_what_nobody_chose_has_its_default() -> None:
    settings = Settings()
    assert (settings["pinel_camera"], settings["pinel_theme"]) == ("0", "")
    assert settings.language in LANGUAGES
    assert settings.of_page().keys() == SETTINGS.keys() - {
        "pinel_camera",
        "pinel_kiosk",
        "pinel_overhead",
        "pinel_recognizer",
        "pinel_resets",
    }


@pytest.mark.parametrize("name", SETTINGS)
def test_each_setting_may_have_the_values_that_it_declares(name: str) -> None:
    setting = SETTINGS[name]
    assert all(setting.allows(value) for value in (setting.default, *(setting.values or ("x_1-",))))
    assert not any(setting.allows(value) for value in ("<b>", "x" * 4001, None, 5))
    assert setting.allows("other") == (setting.values is None)


@pytest.mark.parametrize(
    ("text", "chosen"),
    [
        ("", {}),
        ("[1]", {}),
        ("{", {}),
        ("[" * 100_000, {}),
        (
            '{"pinel_turns": 5, "pinel_theme": "green", "pinel_level": "2", "pinel_class": "ok"}',
            {"pinel_class": "ok"},
        ),
        (json.dumps({"pinel_class": "x" * 5000}), {}),
        (json.dumps({"pinel_class": "x" * 1_000_000}), {}),
    ],
)
def test_of_a_damaged_file_what_can_be_read_is_taken(
    text: str, chosen: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "pinel.db.page.json").write_text(text, "utf-8")
    assert Settings.beside(tmp_path / "pinel.db").chosen == chosen


def test_without_a_place_to_write_they_hold_until_the_app_ends(tmp_path: Path) -> None:
    (tmp_path / "pinel.db.page.json.new").mkdir()
    settings = Settings.beside(tmp_path / "pinel.db")
    settings.choose("pinel_theme", "dark")
    assert settings.chosen == {"pinel_theme": "dark"}


def test_language_and_camera_of_an_older_database_hold_until_others_are_chosen(
    tmp_path: Path,
) -> None:
    database = tmp_path / "pinel.db"
    with open_store(database) as store:
        store.settings.set("language", "es")
        store.settings.set("camera", "1")
    for language, camera in (("es", "1"), ("en", "2")):
        with App(database, make_engine=FakeEngine) as app:
            browser = Browser.signed_in(app.address)
            assert browser.get("/api/status").data["language"] == language
            assert browser.get("/api/camera").data["source"] == camera
            browser.put("/api/settings", {"language": "en"})
            browser.put("/api/camera", {"source": "2"})
