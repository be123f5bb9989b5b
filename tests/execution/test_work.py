"""A loop that does nothing must not freeze anything: work is counted, and Stop is heard in the middle of it."""

import statistics
import time
from typing import Any

import pytest

from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document
from tests.in_time import in_time


def op(name: str, *args: Any) -> dict[str, Any]:
    return {"op": name, "args": list(args)}


def put(name: str, value: Any) -> dict[str, Any]:
    return {"action": "set_variable", "name": name, "value": value}


COUNT, LIST = {"var": "i"}, {"var": "l"}
ONE_MORE = {"action": "change_variable", "name": "i", "by": 1}
NUMBERS = [0.5 * i for i in range(10_000)]


class Stopwatch:
    """A clock that notes how much wall time each tick takes."""

    def __init__(self) -> None:
        self.ticks_s: list[float] = []
        self._last = time.perf_counter()

    def wait_for_tick(self) -> None:
        now = time.perf_counter()
        self.ticks_s.append(now - self._last)
        self._last = now


def run(*commands: Any, **options: Any) -> Any:
    program = read_document({"pinel_ir": 1, "commands": list(commands)}).program
    assert program is not None
    return execute(program, open_link("sim", world="empty_room"), RunOptions(**options))


def test_million_rounds_take_seconds_and_a_minute_of_robot_time() -> None:
    start = time.perf_counter()
    result = run(
        put("i", 0),
        {"action": "while", "condition": op("<", COUNT, 1_000_000), "commands": [ONE_MORE]},
    )
    assert in_time(time.perf_counter() - start, 30)  # about 2.5 s on the PC this was written on
    assert result.variables == {"i": 1_000_000}
    assert 60 < result.ended.duration_s < 90


@pytest.mark.parametrize(
    "command",
    [
        put("x", {"sensor": "distance", "direction": "front"}),
        put("x", op("==", LIST, {"var": "m"})),
        put("x", LIST),
        put("x", op("position_of", {"var": "words"}, "none of them")),
        put("x", op("+", *[op("max", *([op("+", COUNT, 1)] * 100))] * 2)),
        put("x", op("length", op("join", *["x" * 1_000] * 10))),
        {"action": "append", "list": "k", "value": {"var": "i"}},
        {"action": "for", "variable": "j", "from": 1, "to": 9, "commands": []},
    ],
    ids=[
        "rays",
        "lists compared",
        "lists copied",
        "lists searched",
        "sums",
        "texts",
        "append",
        "loops",
    ],
)
def test_tick_full_of_dear_work_stays_shorter_than_a_tick(command: Any) -> None:
    clock = Stopwatch()
    run(
        put("i", 0),
        put("l", NUMBERS),
        put("m", NUMBERS),
        put("k", []),
        put("words", ["a word of it"] * 10_000),
        {"action": "repeat", "times": 1_500, "commands": [command]},
        clock=clock,
    )
    # a few ms on a quiet PC; on a busy one single ticks may take their time
    assert statistics.median(clock.ticks_s) < 1 / 30


def test_stop_is_heard_in_the_middle_of_one_long_expression() -> None:
    class StopSoon(RunControl):
        """Notices how often it is asked."""

        asked = 0

        def __getattribute__(self, name: str) -> Any:
            if name == "stop_requested":
                type(self).asked += 1
                return type(self).asked > 5
            return super().__getattribute__(name)

    long = op("and", *[op("==", LIST, {"var": "m"})] * 10_000)
    start = time.perf_counter()
    result = run(put("l", NUMBERS), put("m", NUMBERS), put("x", long), control=StopSoon())
    assert (result.ended.state, result.ended.reason) == ("stopped", "stopped_by_person")
    assert "x" not in result.variables
    assert in_time(time.perf_counter() - start, 2)


def test_expression_of_a_megabyte_is_worked_out() -> None:
    result = run(put("i", 1), put("x", op("max", *[op("+", COUNT, i) for i in range(15_000)])))
    assert result.variables["x"] == 15_000
    assert result.ended.duration_s * 30 >= 2
