from typing import Any

import pytest

from pinel_desktop.program.python_text import read_python, write_python


def document(text: str) -> Any:
    reading = read_python(text)
    assert reading.faults == ()
    return reading.document


def comments(text: str) -> list[str | None]:
    return [command.get("comment") for command in document(text)["commands"]]


def test_a_comment_belongs_to_the_command_below_it() -> None:
    assert comments("# one\n#\n#  two\n\nrobot.stop()\nrobot.beep()\n") == ["one\n\n two", None]


def test_a_comment_behind_a_command_is_added_to_those_above_it() -> None:
    assert comments("# above\nrobot.stop()  # behind\nrobot.beep()") == ["above\nbehind", None]


def test_a_comment_at_the_end_of_a_block_belongs_to_its_last_command() -> None:
    text = "for _ in range(2):\n    robot.stop()\n    # in the loop\n# below\nrobot.beep()\n# end\n"
    assert comments(text) == [None, "below\nend"]
    assert document(text)["commands"][0]["commands"][0]["comment"] == "in the loop"


def test_a_comment_behind_else_belongs_to_what_follows() -> None:
    text = "if x:\n    robot.stop()\nelse:  # otherwise\n    robot.beep()\n"
    assert document(text)["commands"][0]["else"][0]["comment"] == "otherwise"


def test_a_comment_in_an_empty_block_belongs_to_the_block() -> None:
    assert comments("while True:\n    # nothing yet\n    pass\n") == ["nothing yet"]


def test_a_comment_inside_a_long_command_belongs_to_it() -> None:
    assert comments("robot.go_to(\n    1,  # x\n    # y\n    2,\n)\n") == ["x\ny"]


def test_a_function_keeps_its_comment_and_what_it_begins_with_as_a_text() -> None:
    text = '# above\ndef f():\n    "about"\n    robot.stop()\n    # last\n'
    function = document(text)["functions"][0]
    assert (function["comment"], function["commands"][0]["comment"]) == ("above\nabout", "last")


@pytest.mark.parametrize(
    "comment",
    [
        "",
        "\n",
        " x ",
        "#",
        "\\",
        "\\x41",
        "\\\\x0c",
        "a\x0cb",
        "a\rb",
        "\\\x00",
        "\u2028",
        "coding: x",
    ],
)
def test_any_comment_survives(comment: str) -> None:
    command = {"action": "stop", "comment": comment}
    text = write_python({"functions": [], "commands": [command]}).text
    assert document(text)["commands"] == [command]


def test_a_number_sign_in_a_text_is_no_comment() -> None:
    assert comments('robot.say("# no")\nx = """\n# no\n"""\n') == [None, None]
