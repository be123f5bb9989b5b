"""The committed files that are made from the code's declarations are current."""

from pathlib import Path

from scripts.reference.files import files

ROOT = Path(__file__).parents[2]


def test_the_files_made_from_declarations_are_current() -> None:
    made = files(ROOT)  # takes seconds: not while tests are collected, which each process does
    old = [name for name, text in made.items() if (ROOT / name).read_text("utf-8") != text]
    assert old == [], "run python -m scripts.reference"
