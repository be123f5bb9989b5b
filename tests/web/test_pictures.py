"""The page draws every picture and offers every colour that the store knows, in the same order."""

import re
from pathlib import Path

from storage.choices import COLORS, PICTURES

ROOT = Path(__file__).parents[2] / "ui" / "src"
TABLE = (ROOT / "kit" / "pictures" / "pictures.ts").read_text("utf-8")


def test_there_is_a_drawing_for_each_picture() -> None:
    table = TABLE.split("PICTURES = {")[1].split("}")[0]
    assert tuple(re.findall(r"^  (\w+): ", table, re.M)) == PICTURES


def test_the_colours_are_the_same() -> None:
    assert tuple(re.findall(r'"(#[0-9a-f]{6})"', TABLE)) == COLORS


def test_each_picture_has_a_name_in_three_languages() -> None:
    for language in ("pt-BR", "en", "es"):
        words = (ROOT / "i18n" / language / "classes.ts").read_text("utf-8")
        table = words.split("pictures: {")[1].split("}")[0]
        assert tuple(re.findall(r"^    (\w+): ", table, re.M)) == PICTURES
