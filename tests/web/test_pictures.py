"""The page draws all group pictures of the store, in the same order."""

import json
import re
from pathlib import Path

from storage.choices import PICTURES

ROOT = Path(__file__).parents[2] / "ui" / "src"
CATALOGUE = ROOT.parents[1] / "pinel_desktop" / "messages" / "catalogue"
TABLE = (ROOT / "kit" / "pictures" / "pictures.ts").read_text("utf-8")


def test_there_is_a_drawing_for_each_picture() -> None:
    table = TABLE.split("PICTURES = {")[1].split("}")[0]
    assert tuple(re.findall(r"^  (\w+): ", table, re.M)) == PICTURES


def test_each_picture_has_a_name_in_portuguese() -> None:
    """Other languages have the keys of Portuguese (scripts/catalogue.py)."""
    text = (CATALOGUE / "pt-BR" / "page" / "classes.json").read_text("utf-8")
    assert tuple(json.loads(text)["classes"]["pictures"]) == PICTURES
