"""Every program under tests/programs runs and meets the values in NAME.values.json beside it.

A value is given exactly, or as {"equals", "within"}, {"min"} and {"max"}; `heading_deg`, `x_m` and `y_m` are
those of the final pose, `said` is what the program said. `world` and `gestures` are what the program is run with.

Each program is there three times: as a document, as Python (python/NAME.py) and as blocks with what the generator of
the page makes of them (blocks/NAME.json, held by ui/src/blocks/loader/programs.test.ts).
"""

import json
import math
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.links import open_link
from pinel_desktop.program.python_text import read_python, write_python
from pinel_desktop.program.reading import ParseResult, read_document

PROGRAMS = Path(__file__).parent / "programs"
NAMES = sorted(path.stem for path in PROGRAMS.glob("*.json") if not path.stem.endswith(".values"))


def values_of(name: str) -> dict[str, Any]:
    values: dict[str, Any] = json.loads((PROGRAMS / f"{name}.values.json").read_text("utf-8"))
    return values


def read(name: str) -> ParseResult:
    return read_document((PROGRAMS / f"{name}.json").read_bytes())


def run(reading: ParseResult, values: dict[str, Any]) -> RunResult:
    program = reading.program
    assert program is not None
    link = open_link("sim", world=values.get("world", "empty_room"))
    return execute(program, link, RunOptions(inputs=ScriptedInputs(values.get("gestures", []))))


def measured(result: RunResult) -> dict[str, Any]:
    ended = result.ended
    assert ended.pose is not None
    return {
        "state": ended.state,
        "reason": ended.reason,
        "n_executed": ended.n_executed,
        "duration_s": ended.duration_s,
        "path_length_m": ended.path_length_m,
        "closing_error_m": ended.closing_error_m,
        "heading_deg": math.degrees(ended.pose["yaw_rad"]),
        "x_m": ended.pose["x_m"],
        "y_m": ended.pose["y_m"],
        "said": result.shown_texts,
    }


def meets(value: Any, expected: Any) -> bool:
    if not isinstance(expected, dict):
        return bool(value == expected)
    low, high = expected.get("min", -math.inf), expected.get("max", math.inf)
    if "equals" in expected:
        low, high = expected["equals"] - expected["within"], expected["equals"] + expected["within"]
    return bool(low <= value <= high)


@pytest.mark.parametrize("name", NAMES)
def test_program_meets_its_values(name: str) -> None:
    values = values_of(name)
    figures = measured(run(read(name), values))
    checks = {key: expected for key, expected in values.items() if key in figures}
    assert len(checks) >= 2
    assert set(values) <= {*figures, "about", "world", "gestures"}
    missed = {
        key: (figures[key], expected)
        for key, expected in checks.items()
        if not meets(figures[key], expected)
    }
    assert missed == {}


@pytest.mark.parametrize("name", NAMES)
def test_program_runs_the_same_again_to_the_bit(name: str) -> None:
    values = values_of(name)
    assert run(read(name), values).ended == run(read(name), values).ended


@pytest.mark.parametrize("name", NAMES)
def test_program_runs_alike_from_document_python_and_blocks(name: str) -> None:
    values = values_of(name)
    text = (PROGRAMS / "python" / f"{name}.py").read_text("utf-8")
    blocks = json.loads((PROGRAMS / "blocks" / f"{name}.json").read_text("utf-8"))
    variants = [read(name), read_python(text).result, read_document(blocks["document"])]
    endings = [run(variant, values).ended for variant in variants]
    assert {ending.telemetry_sha256 for ending in endings} == {endings[0].telemetry_sha256}
    assert {(e.state, e.reason, e.n_executed) for e in endings} == {
        (endings[0].state, endings[0].reason, endings[0].n_executed)
    }


@pytest.mark.parametrize("name", NAMES)
def test_python_beside_a_program_is_what_is_written_of_it(name: str) -> None:
    document = read(name).document
    assert document is not None
    text = (PROGRAMS / "python" / f"{name}.py").read_text("utf-8")
    assert write_python(document).text == text
