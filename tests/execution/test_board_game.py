"""Experiment 6 of the dissertation in the whole language: a pupil signs a cell, the robot goes there and marks it."""

from typing import Any

import pytest

from pinel_desktop.execution.inputs import ScriptedInputs


def op(name: str, *args: Any) -> dict[str, Any]:
    return {"op": name, "args": list(args)}


def var(name: str) -> dict[str, Any]:
    return {"var": name}


def loop(variable: str, first: int, last: int, *commands: Any) -> dict[str, Any]:
    return {
        "action": "for",
        "variable": variable,
        "from": first,
        "to": last,
        "commands": list(commands),
    }


GO_TO_CELL = {
    "name": "ir para",
    "parameters": ["casa"],
    "commands": [
        loop(
            "linha",
            0,
            2,
            loop(
                "coluna",
                1,
                3,
                {
                    "action": "conditional_execution",
                    "condition": op(
                        "==",
                        op("item", var("casas"), op("+", op("*", var("linha"), 3), var("coluna"))),
                        var("casa"),
                    ),
                    "commands": [
                        {"action": "go_to", "x": var("coluna"), "y": op("-", 0, var("linha"))},
                        {"action": "mark", "symbol": "X"},
                        {"action": "say", "text": op("join", "Estou em ", {"sensor": "cell"})},
                        {"action": "return"},
                    ],
                },
            ),
        )
    ],
}


def test_robot_marks_the_cells_that_were_signed(execute_commands: Any) -> None:
    result, _ = execute_commands(
        {"action": "set_variable", "name": "casas", "value": list("ABCDEFGIL")},
        loop(
            "i",
            1,
            4,
            {"action": "classify_gestures"},
            {"action": "call", "function": "ir para", "arguments": {"casa": {"gesture": "result"}}},
        ),
        functions=[GO_TO_CELL],
        inputs=ScriptedInputs(list("ALGI")),
        world="tic_tac_toe",
    )
    assert result.ended.state == "finished"
    assert result.shown_texts == [f"Estou em {cell}" for cell in "ALGI"]
    places = [(mark.x_m, mark.y_m) for mark in result.marks]
    for place, cell in zip(places, [(1, 0), (3, -2), (1, -2), (2, -2)], strict=True):
        assert place == pytest.approx(cell, abs=1e-3)
    assert result.ended.path_length_m == pytest.approx(1 + 2 * 2**0.5 + 2 + 1, abs=0.01)
