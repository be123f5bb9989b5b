from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from pinel_desktop.events.model import Event
from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document

Log = list[tuple[int, Event]]
Execute = Callable[..., tuple[RunResult, Log]]


@pytest.fixture
def execute_commands() -> Execute:
    """Runs commands in the real simulator as fast as it goes; gives the result and all events."""

    def run(
        *commands: dict[str, Any], world: str = "empty_room", **options: Any
    ) -> tuple[RunResult, Log]:
        program = read_document({"pinel_ir": 1, "commands": list(commands)}).program
        assert program is not None
        log: Log = []
        listener = options.pop("listener", None)

        def observe(tick: int, event: Event) -> None:
            log.append((tick, event))
            if listener is not None:
                listener(tick, event)

        setup = replace(RunOptions(**options), observer=observe)
        return execute(program, open_link("sim", world=world), setup), log

    return run
