"""Whatever a valid program says, a run of it keeps the promises every run keeps."""

import json
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pinel_desktop.events.model import (
    BlockEnded,
    BlockStarted,
    Event,
    RunEnded,
    RunState,
    Telemetry,
)
from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.execution.gestures import ScriptedGestures
from pinel_desktop.links import open_link
from pinel_desktop.program.reading import read_document

LETTERS = st.sampled_from(["A", "B", "b", ""])
LEAVES = st.one_of(
    st.builds(lambda d: {"action": "move_forward", "distance": d}, st.floats(0, 5)),
    st.builds(lambda d: {"action": "move_backward", "distance": d}, st.floats(0, 5)),
    st.builds(lambda a: {"action": "turn", "angle": a}, st.floats(-720, 720)),
    st.builds(lambda s: {"action": "wait", "seconds": s}, st.floats(0, 2)),
    st.builds(lambda t: {"action": "classify_gestures", "timeout": t}, st.floats(0.01, 2)),
    st.builds(lambda r: {"action": "set_gesture_result", "result": r}, LETTERS),
    st.just({"action": "stop"}),
)
CONDITIONS = st.one_of(
    st.builds(lambda r: f'result == "{r}"', LETTERS),
    st.builds(
        lambda r: {"op": "not", "args": [{"op": "==", "args": [{"gesture": "result"}, r]}]}, LETTERS
    ),
    st.booleans(),
)


def _containers(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    bodies = st.lists(inner, max_size=3)
    branches = st.lists(
        st.builds(lambda c, b: {"condition": c, "commands": b}, CONDITIONS, bodies), max_size=2
    )
    return st.one_of(
        st.builds(
            lambda n, b: {"action": "repeat", "times": n, "commands": b}, st.integers(0, 3), bodies
        ),
        st.builds(
            lambda c, b, elif_, else_: {
                "action": "conditional_execution",
                "condition": c,
                "commands": b,
                "elif": elif_,
                "else": else_,
            },
            CONDITIONS,
            bodies,
            branches,
            bodies,
        ),
    )


PROGRAMS = st.lists(st.recursive(LEAVES, _containers, max_leaves=6), max_size=4)
SLOW = settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])


def run(document: Any, world: str, answers: list[str]) -> tuple[RunResult, list[tuple[int, Event]]]:
    reading = read_document(document)
    assert reading.program is not None, reading.faults
    log: list[tuple[int, Event]] = []
    options = RunOptions(
        observer=lambda tick, event: log.append((tick, event)), gestures=ScriptedGestures(answers)
    )
    return execute(reading.program, open_link("sim", world=world), options), log


@SLOW
@given(PROGRAMS, st.sampled_from(["empty_room", "obstacles"]), st.lists(LETTERS, max_size=3))
def test_run_ends_once_at_rest_with_a_reason_and_balanced_blocks(
    commands: list[Any], world: str, answers: list[str]
) -> None:
    result, log = run(commands, world, answers)
    ended = result.ended
    assert (ended.state, ended.reason) in {("finished", None), ("failed", "blocked")}
    assert [event for _, event in log if isinstance(event, RunEnded)] == [log[-1][1]]
    assert isinstance(log[0][1], RunState)
    telemetry = [event for _, event in log if isinstance(event, Telemetry)]
    if telemetry:
        assert (telemetry[-1].command_v_mps, telemetry[-1].command_omega_radps) == (0.0, 0.0)
        assert abs(telemetry[-1].v_mps) < 1e-3
    open_blocks = [event for _, event in log if isinstance(event, BlockStarted)]
    closed = [event for _, event in log if isinstance(event, BlockEnded)]
    assert ended.state == "failed" or len(open_blocks) == len(closed)


@SLOW
@given(PROGRAMS, st.lists(LETTERS, max_size=3))
def test_normal_form_runs_like_the_document_it_came_from(
    commands: list[Any], answers: list[str]
) -> None:
    normal = read_document(commands).document
    assert normal is not None
    first, _ = run(commands, "obstacles", answers)
    again, _ = run(json.loads(json.dumps(normal)), "obstacles", answers)
    assert again.ended == first.ended
