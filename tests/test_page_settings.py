"""What the page keeps on this PC outlives window and app."""

import json
from pathlib import Path

import pytest

from pinel_desktop.page_settings import MAX_SETTINGS, PageSettings


def test_settings_are_there_when_the_app_starts_again(tmp_path: Path) -> None:
    database = tmp_path / "pinel.db"
    settings = PageSettings.beside(database)
    settings.keep("pinel_theme", "dark")
    settings.keep("pinel_level", "1")
    settings.keep("pinel_level", "2")
    again = PageSettings.beside(database)
    assert again.values == {"pinel_theme": "dark", "pinel_level": "2"}
    again.keep("pinel_theme", "")
    assert PageSettings.beside(database).values == {"pinel_level": "2"}
    assert [file.name for file in tmp_path.iterdir()] == ["pinel.db.page.json"]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("", {}),
        ("[1]", {}),
        ("{", {}),
        ("[" * 100_000, {}),
        ('{"a": 5, "b": "<b>", "c d": "x", "e": "ok"}', {"e": "ok"}),
        (json.dumps({"a": "x" * 5000}), {}),
        (json.dumps({"a": "x" * 1_000_000}), {}),
    ],
)
def test_a_damaged_file_holds_what_can_be_read(
    text: str, values: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "pinel.db.page.json").write_text(text, "utf-8")
    assert PageSettings.beside(tmp_path / "pinel.db").values == values


def test_without_a_place_to_write_they_hold_until_the_app_ends(tmp_path: Path) -> None:
    (tmp_path / "pinel.db.page.json.new").mkdir()
    settings = PageSettings.beside(tmp_path / "pinel.db")
    settings.keep("pinel_theme", "dark")
    assert settings.values == {"pinel_theme": "dark"}


def test_they_stay_few() -> None:
    settings = PageSettings()
    for number in range(2 * MAX_SETTINGS):
        settings.keep("x" * (number + 1) if number < 40 else "y" * (number - 39), "1")
    assert len(settings.values) == MAX_SETTINGS
