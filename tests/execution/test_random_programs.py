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
from pinel_desktop.execution.control import RunControl
from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.links import open_link
from pinel_desktop.messages import SOURCE_LANGUAGE, catalogue
from pinel_desktop.program.reading import read_document
from tests.strategies import LETTERS, programs

WORLDS = st.sampled_from(["empty_room", "obstacles", "tic_tac_toe"])
SLOW = settings(
    max_examples=150,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
Log = list[tuple[int, Event]]


def run(document: Any, world: str, gestures: list[str], seed: int = 0) -> tuple[RunResult, Log]:
    reading = read_document(document)
    assert reading.program is not None, reading.faults
    log: Log = []
    options = RunOptions(
        observer=lambda tick, event: log.append((tick, event)),
        inputs=ScriptedInputs(gestures, ["3", "0.5", "Ana"]),
        seed=seed,
    )
    return execute(reading.program, open_link("sim", world=world), options), log


@SLOW
@given(programs(), WORLDS, st.lists(LETTERS, max_size=3), st.integers(0, 99))
def test_run_ends_once_at_rest_with_a_reason_in_words_and_the_same_again_to_the_bit(
    document: Any, world: str, gestures: list[str], seed: int
) -> None:
    result, log = run(document, world, gestures, seed)
    ended = result.ended
    assert ended.state in ("finished", "failed")
    assert ended.reason != "internal_error", ended.params
    assert (ended.reason is None) == (ended.state == "finished")
    assert ended.reason is None or ended.reason in catalogue(SOURCE_LANGUAGE)
    assert [event for _, event in log if isinstance(event, RunEnded)] == [log[-1][1]]
    assert isinstance(log[0][1], RunState)
    telemetry = [event for _, event in log if isinstance(event, Telemetry)]
    if telemetry:
        assert (telemetry[-1].command_v_mps, telemetry[-1].command_omega_radps) == (0.0, 0.0)
        assert abs(telemetry[-1].v_mps) < 1e-3
    _assert_balanced(log, all_closed=ended.state == "finished")
    again, log_again = run(document, world, gestures, seed)
    assert (again.ended, log_again) == (ended, log)
    assert (again.shown_texts, again.variables) == (result.shown_texts, result.variables)
    json.dumps([ended.params, result.variables], allow_nan=False)


def _assert_balanced(log: Log, *, all_closed: bool) -> None:
    opened: list[str] = []
    for _, event in log:
        if isinstance(event, BlockStarted):
            opened.append(event.pointer)
        elif isinstance(event, BlockEnded):
            assert opened.pop() == event.pointer
    assert not (all_closed and opened)


@settings(SLOW, max_examples=50)
@given(programs(), st.lists(LETTERS, max_size=3))
def test_normal_form_runs_like_the_document_it_came_from(
    document: Any, gestures: list[str]
) -> None:
    normal = read_document(document).document
    assert normal is not None
    first, _ = run(document, "obstacles", gestures)
    again, _ = run(json.loads(json.dumps(normal)), "obstacles", gestures)
    assert again.ended == first.ended


@settings(SLOW, max_examples=50)
@given(programs(), st.integers(0, 60))
def test_stop_ends_every_program_wherever_it_comes(document: Any, at: int) -> None:
    program = read_document(document).program
    assert program is not None
    control, n_events = RunControl(), 0

    def press(_tick: int, _event: Event) -> None:
        nonlocal n_events
        n_events += 1
        if n_events > at:
            control.stop()

    options = RunOptions(observer=press, control=control)
    ended = execute(program, open_link("sim", world="empty_room"), options).ended
    assert ended.state in ("stopped", "finished", "failed")
    assert ended.reason != "internal_error", ended.params
