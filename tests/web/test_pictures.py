"""The page draws all group pictures of the store, in the same order."""

import re
from pathlib import Path

from storage.choices import PICTURES

ROOT = Path(__file__).parents[2] / "ui" / "src"
TABLE = (ROOT / "kit" / "pictures" / "pictures.ts").read_text("utf-8")


def test_there_is_a_drawing_for_each_picture() -> None:
    table = TABLE.split("PICTURES = {")[1].split("}")[0]
    assert tuple(re.findall(r"^  (\w+): ", table, re.M)) == PICTURES


def test_each_picture_has_a_name_in_three_languages() -> None:
    for language in ("pt-BR", "en", "es"):
        text = (ROOT / "i18n" / language / "classes.ts").read_text("utf-8")
        table = text.split("pictures: {")[1].split("}")[0]
        assert tuple(re.findall(r"^    (\w+): ", table, re.M)) == PICTURES
