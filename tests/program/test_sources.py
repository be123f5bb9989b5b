import json

import pytest

from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.sources import is_python, read_source

DOCUMENT = json.dumps({"pinel_ir": 1, "commands": [{"action": "stop"}]}).encode()
BARE_LIST = b'\n[{"action": "stop"}]'
PYTHON = b"# hello\nrobot.stop()\n"


@pytest.mark.parametrize(
    ("data", "name", "expected"),
    [
        (DOCUMENT, "", False),
        (BARE_LIST, "program", False),
        (b"\xef\xbb\xbf" + DOCUMENT, "", False),
        (b"", "", False),
        (PYTHON, "", True),
        (PYTHON, "program.txt", True),
        (b"", "empty.PY", True),
        (PYTHON, "program.json", False),
        (b"[1]", "list.py", True),
    ],
)
def test_the_name_decides_or_else_the_first_character(
    data: bytes, name: str, expected: bool
) -> None:
    assert is_python(data, name) is expected


@pytest.mark.parametrize("data", [DOCUMENT, BARE_LIST, PYTHON, b"\xef\xbb\xbf" + PYTHON])
def test_all_ways_to_write_a_program_are_read(data: bytes) -> None:
    document = read_source(data).document
    assert document is not None
    assert [command["action"] for command in document["commands"]] == ["stop"]


def test_bytes_that_are_no_text_are_a_fault_with_its_place() -> None:
    (fault,) = read_source("robot.say('é')\nx = 'á\u00e9'".encode("utf-8") + b"\xe9'").faults
    assert (fault.code, fault.params) == ("python_not_utf8", {"line": 2, "column": 9})


def test_a_file_beyond_the_limit_is_a_fault() -> None:
    (fault,) = read_source(b"#" * (MAX_BYTES + 1), "a.py").faults
    assert fault.code == "document_too_large"
