"""Breakpoints and steps, on the real simulator."""

from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event, RunEnded, RunState
from pinel_desktop.execution.control import RunControl, StepMode
from pinel_desktop.execution.executor import RunOptions, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document

Json = dict[str, Any]


def beep(block: str) -> Json:
    return {"action": "beep", "block": block}


def call(function: str, block: str) -> Json:
    return {"action": "call", "function": function, "block": block}


NESTED: Json = {
    "pinel_ir": 1,
    "functions": [
        {"name": "outer", "commands": [beep("x"), call("inner", "y"), beep("z")]},
        {"name": "inner", "commands": [beep("q")]},
    ],
    "commands": [
        {"action": "move_forward", "distance": 0.1, "block": "a"},
        call("outer", "b"),
        beep("c"),
    ],
}
LOOP: Json = {
    "pinel_ir": 1,
    "commands": [
        {"action": "repeat", "times": 3, "block": "loop", "commands": [beep("in"), beep("next")]},
        beep("after"),
    ],
}


class Session:
    """Runs a program; at each pause somebody does the next thing of a list, and goes on at its end."""

    def __init__(self, document: Json, control: RunControl) -> None:
        self.pauses: list[tuple[str | None, str | None]] = []
        self._control = control
        self._acts: list[Callable[[], None]] = []
        self.ended: RunEnded | None = None
        self._document = document

    def run(self, *acts: Callable[[], None]) -> list[str | None]:
        self._acts = list(acts)
        program = read_document(self._document).program
        assert program is not None
        options = RunOptions(observer=self._observe, control=self._control)
        self.ended = execute(program, open_link("sim", world="empty_room"), options).ended
        return [block for _, block in self.pauses]

    def _observe(self, _tick: int, event: Event) -> None:
        if isinstance(event, RunState) and event.state == "paused":
            self.pauses.append((event.cause, event.block))
            act = self._acts.pop(0) if self._acts else self._control.resume
            act()


@pytest.fixture
def control() -> RunControl:
    return RunControl()


def steps(control: RunControl, mode: StepMode, times: int) -> list[Callable[[], None]]:
    return [lambda: control.step_on(mode)] * times


def test_stepping_into_meets_every_block_in_its_order(control: RunControl) -> None:
    control.step = "into"
    session = Session(NESTED, control)
    assert session.run(*steps(control, "into", times=10)) == ["a", "b", "x", "y", "q", "z", "c"]
    assert {cause for cause, _ in session.pauses} == {"step"}
    assert session.ended is not None
    assert session.ended.state == "finished"


def test_stepping_over_goes_through_functions_without_holding(control: RunControl) -> None:
    control.step = "into"
    session = Session(NESTED, control)
    assert session.run(*steps(control, "over", times=10)) == ["a", "b", "c"]


def test_stepping_out_leaves_the_function(control: RunControl) -> None:
    control.breakpoints = frozenset("q")
    session = Session(NESTED, control)
    assert session.run(*steps(control, "out", times=3)) == ["q", "z", "c"]
    assert [cause for cause, _ in session.pauses] == ["breakpoint", "step", "step"]


def test_a_breakpoint_holds_at_each_round_of_a_loop(control: RunControl) -> None:
    control.breakpoints = frozenset(["next"])
    session = Session(LOOP, control)
    assert session.run() == ["next", "next", "next"]
    assert session.ended is not None
    assert session.ended.n_executed == 7


def test_a_breakpoint_may_be_taken_away_while_the_run_stands(control: RunControl) -> None:
    control.breakpoints = frozenset(["next"])

    def free() -> None:
        control.breakpoints = frozenset()
        control.resume()

    assert Session(LOOP, control).run(free) == ["next"]


def test_a_breakpoint_holds_a_step_that_would_go_past_it(control: RunControl) -> None:
    control.step = "into"
    control.breakpoints = frozenset("q")
    session = Session(NESTED, control)
    assert session.run(*steps(control, "over", times=10)) == ["a", "b", "q", "z", "c"]


def test_stop_ends_a_held_run_before_the_block_begins(control: RunControl) -> None:
    control.breakpoints = frozenset("c")
    session = Session(NESTED, control)
    assert session.run(control.stop) == ["c"]
    assert session.ended is not None
    assert (session.ended.state, session.ended.n_executed) == ("stopped", 4)


def test_a_person_pauses_in_the_middle_of_a_block_and_steps_to_the_next() -> None:
    class Impatient(RunControl):
        """Pauses once, as the motion has begun."""

        asked = 0

        @property
        def pause_requested(self) -> bool:
            self.asked += 1
            if self.asked == 10:
                self._requested = True
            return self._requested

        @pause_requested.setter
        def pause_requested(self, value: bool) -> None:
            self._requested = value

    control = Impatient()
    session = Session(NESTED, control)
    assert session.run(*steps(control, "over", times=1)) == ["a", "b"]
    assert [cause for cause, _ in session.pauses] == ["person", "step"]


def test_speed_stays_within_what_a_pc_can_do() -> None:
    control = RunControl()
    control.set_speed(1000)
    assert control.speed == 10
    control.set_speed(0)
    assert control.speed == 0.1


COUNTING: Json = {
    "pinel_ir": 1,
    "commands": [
        {"action": "set_variable", "name": "n", "value": 20},
        {"action": "set_variable", "name": "l", "value": ["a"] * 50},
        {"action": "change_variable", "name": "n", "by": 1.5, "block": "here"},
    ],
}


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ({"var": "n"}, 20),
        ({"op": "*", "args": [{"var": "n"}, 2]}, 40),
        ({"sensor": "x"}, 0),
        ({"sensor": "cell"}, ""),
        ({"op": "length", "args": [{"var": "l"}]}, 50),
        ({"var": "l"}, ["a"] * 20 + ["…"]),
        ("text", "text"),
        ({"var": "nothing"}, "unset_variable"),
        ({"op": "/", "args": [1, 0]}, "division_by_zero"),
        ({"op": "random_int", "args": [1, 6]}, "peek_not_possible"),
        ({"op": "+", "args": [1, {"call": "f"}]}, "peek_not_possible"),
        ({"op": "+", "args": [1]}, "peek_invalid"),
        ({"what": 1}, "peek_invalid"),
        (None, "peek_invalid"),
    ],
)
def test_values_are_told_while_the_run_stands(
    control: RunControl, expression: Any, value: Any
) -> None:
    control.breakpoints = frozenset(["here"])
    replies: list[Any] = []

    def answer(found: Any, error: PinelError | None) -> None:
        replies.append(found if error is None else error.code)
        control.resume()

    def observe(_tick: int, event: Event) -> None:
        if isinstance(event, RunState) and event.state == "paused":
            control.evaluate(expression, answer)

    program = read_document(COUNTING).program
    assert program is not None
    options = RunOptions(observer=observe, control=control)
    result = execute(program, open_link("sim", world="empty_room"), options)
    assert replies == [value]
    assert result.ended.state == "finished"
    assert result.variables["n"] == 21.5
