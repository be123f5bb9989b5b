"""Document -> Python -> document is the identity, up to block ids and the normal form."""

import ast
import json
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from pinel_desktop.program.python_text import read_python, write_python
from pinel_desktop.program.reading import read_document
from tests.python_text.languages import Document, documents, normal

PROGRAMS = Path(__file__).parents[1] / "programs"
NAMES = sorted(path.stem for path in PROGRAMS.glob("*.json") if not path.stem.endswith(".values"))
SLOW = settings(max_examples=200, deadline=None, suppress_health_check=list(HealthCheck))


@SLOW
@given(documents())
def test_any_program_comes_back_from_its_python_text(document: Document) -> None:
    read = read_document(document).document
    assert read is not None, read_document(document).faults
    written = write_python(read)
    ast.parse(written.text)
    reading = read_python(written.text)
    assert reading.faults == (), written.text
    assert reading.document is not None
    assert normal(reading.document) == normal(document), written.text
    assert write_python(reading.document).text == written.text
    assert {n: line.pointer for n, line in reading.lines.items()} == {
        n: line.pointer for n, line in written.lines.items()
    }


@pytest.mark.parametrize("name", NAMES)
def test_every_program_of_the_tests_comes_back(name: str) -> None:
    read = read_document((PROGRAMS / f"{name}.json").read_bytes()).document
    assert read is not None
    again = read_python(write_python(read).text).document
    assert normal(json.loads(json.dumps(again))) == normal(read)
