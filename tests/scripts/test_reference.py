"""The committed files that are made from the code's declarations are current."""

from pathlib import Path

import pytest

from scripts.reference.files import files

ROOT = Path(__file__).parents[2]
FILES = files(ROOT)


@pytest.mark.parametrize("name", FILES)
def test_a_file_made_from_declarations_is_current(name: str) -> None:
    current = (ROOT / name).read_text("utf-8") == FILES[name]
    assert current, "run python -m scripts.reference"
