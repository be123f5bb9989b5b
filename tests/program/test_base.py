import copy
import pickle
from dataclasses import FrozenInstanceError
from typing import Any

import pytest

from pinel_desktop.program.model import Program, Say, SetSpeed
from pinel_desktop.program.reading import read_document

COMMANDS: list[dict[str, Any]] = [
    {"action": "say", "text": {"op": "+", "args": [{"var": "a"}, 1]}, "block": "b"},
    {"action": "set_speed", "linear": 0.2},
    {"action": "while", "condition": True, "commands": [{"action": "break"}]},
]


def program(*commands: dict[str, Any]) -> Program:
    read = read_document({"pinel_ir": 1, "commands": list(commands)}).program
    assert read is not None
    return read


def test_what_was_read_does_not_change() -> None:
    command = program(*COMMANDS).commands[0]
    with pytest.raises(FrozenInstanceError, match="block"):
        command.block = "c"  # type: ignore[misc]
    with pytest.raises(FrozenInstanceError, match="block"):
        del command.block
    assert command.block == "b"


def test_commands_have_no_room_for_more_than_their_fields() -> None:
    assert not any(hasattr(command, "__dict__") for command in program(*COMMANDS).commands)


def test_a_program_goes_to_another_process_and_is_copied() -> None:
    read = program(*COMMANDS)
    assert pickle.loads(pickle.dumps(read)) == read
    assert copy.deepcopy(read) == read


def test_programs_are_the_same_when_they_hold_the_same() -> None:
    first, speed, _ = COMMANDS
    assert program(first) == program(dict(first))
    assert program(first) != program(speed)
    one, other = program(speed), program({**speed, "linear": 0.3})
    assert one != other
    assert len({one.commands[0], program(speed).commands[0], other.commands[0]}) == 2


def test_a_command_shows_what_it_holds() -> None:
    command, speed, _ = program(*COMMANDS).commands
    assert isinstance(command, Say)
    assert isinstance(speed, SetSpeed)
    assert repr(command.text) == "Operation(op='+', args=[Variable(var='a'), 1.0])"
    assert repr(speed) == (
        "SetSpeed(block=None, comment=None, action='set_speed', linear=0.2, angular=None)"
    )
