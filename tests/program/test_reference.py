"""The files that are made from the models of the language are current."""

from pathlib import Path

import pytest

from pinel_desktop.program.reference.files import files

ROOT = Path(__file__).parents[2]
FILES = files(ROOT)


@pytest.mark.parametrize("name", FILES)
def test_a_file_made_from_the_models_is_current(name: str) -> None:
    current = (ROOT / name).read_text("utf-8") == FILES[name]
    assert current, "run python -m pinel_desktop.program.reference"
