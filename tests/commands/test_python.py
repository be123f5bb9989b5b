"""`pinel python` on the command line."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from pinel_desktop.cli import main

PROGRAMS = Path(__file__).parents[1] / "programs"
SQUARE = """\
for _ in range(4):
    robot.move_forward(1.0)
    robot.turn(-90)
"""


@pytest.fixture(autouse=True)
def language(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PINEL_LANG", "en")


def pinel_python(*arguments: str, text: str | bytes | None = None) -> Result:
    result = CliRunner().invoke(main, ["python", *arguments], input=text)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


def test_a_document_is_printed_as_python_text() -> None:
    result = pinel_python(str(PROGRAMS / "square.json"))
    assert (result.exit_code, result.stderr) == (0, "")
    assert result.stdout.endswith(SQUARE)


def test_what_a_bare_list_has_too_much_is_said_and_the_text_is_printed() -> None:
    result = pinel_python("-", text='[{"action": "stop", "status": "pending"}]')
    assert (result.exit_code, result.stdout) == (0, "robot.stop()\n")
    assert result.stderr.startswith("/0/status: ")


def test_python_text_is_printed_in_its_normal_form_or_as_a_document(tmp_path: Path) -> None:
    file = tmp_path / "square.py"
    file.write_text("for _ in range( 4 ) :\n  robot.move_forward(1);robot.turn( - 90 )\n", "utf-8")
    assert pinel_python(str(file)).stdout == SQUARE
    document = json.loads(pinel_python(str(file), "--json").stdout)
    assert document["commands"][0]["times"] == 4


def test_faults_are_said_with_line_and_column_and_the_status_is_2() -> None:
    result = pinel_python("-", text="robot.turn(9999)\nimport os\n")
    assert (result.exit_code, result.stdout) == (2, "")
    assert [line.split(":")[0] for line in result.stderr.splitlines()] == [
        "Line 1, column 12",
        "Line 2, column 1",
    ]


def test_faults_of_a_document_are_said_with_their_place_in_it() -> None:
    result = pinel_python("-", text='[{"action": "turn", "angle": 9999}]')
    assert result.exit_code == 2
    assert result.stderr.startswith("/0/angle: The angle 9999 ")


def test_a_file_that_is_not_there_is_said_and_the_status_is_2() -> None:
    result = pinel_python("nowhere.py")
    assert result.exit_code == 2
    assert "nowhere.py" in result.stderr
