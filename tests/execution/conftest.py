import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from pinel_desktop.events.model import Event
from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.links import open_link
from pinel_desktop.messages import LANGUAGES, describe
from pinel_desktop.program.reading import read_document

Log = list[tuple[int, Event]]
Execute = Callable[..., tuple[RunResult, Log]]


@pytest.fixture
def execute_commands() -> Execute:
    """Runs commands in the real simulator at full speed; returns the result and all events."""

    def run(
        *commands: dict[str, Any],
        world: str = "empty_room",
        functions: list[dict[str, Any]] | None = None,
        **options: Any,
    ) -> tuple[RunResult, Log]:
        document = {"pinel_ir": 1, "functions": functions or [], "commands": list(commands)}
        reading = read_document(document)
        program = reading.program
        assert program is not None, reading.faults
        log: Log = []
        listener = options.pop("listener", None)

        def observe(tick: int, event: Event) -> None:
            log.append((tick, event))
            if listener is not None:
                listener(tick, event)

        setup = replace(RunOptions(**options), observer=observe)
        result = execute(program, open_link("sim", world=world), setup)
        _assert_has_texts(result)
        return result, log

    return run


def _assert_has_texts(result: RunResult) -> None:
    """Checks that the reason has a text in every language, with all parameters."""
    ended = result.ended
    if ended.reason is not None:
        for language in LANGUAGES:
            description = describe(ended.reason, ended.params, language)
            assert description.message != ended.reason
            assert not re.search(r"\{\w+\}", description.message + description.remedy), (
                ended.reason,
                description,
            )


@pytest.fixture
def value_of(execute_commands: Execute) -> Callable[..., Any]:
    """Value of an expression, computed by a run; of a failed run (reason, params)."""

    def value(expression: Any, *before: dict[str, Any], gesture: str = "", **options: Any) -> Any:
        result, _ = execute_commands(
            *before,
            {"action": "set_gesture_result", "result": gesture},
            {"action": "set_variable", "name": "value", "value": expression, "block": "here"},
            **options,
        )
        if result.ended.state == "failed":
            assert result.ended.block == "here"
            return result.ended.reason, result.ended.params
        return result.variables["value"]

    return value
