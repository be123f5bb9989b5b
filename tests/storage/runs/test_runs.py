"""Runs: begun, recorded, ended, read back."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import RunEnded
from pinel_desktop.events.types import RECORDED, URGENT
from storage import GroupRow, RunRecorder, RunRow, RunStart, Store, StoreError, VersionRow
from storage.exchange.deleting.deletion import purge_keys
from storage.sqlite import sqlite3
from tests.storage.sample_documents import SQUARE, WORLD
from tests.storage.sample_runs import block_started, ended, sample, square


class ManualClock:
    def __init__(self) -> None:
        self.now_s = 0.0

    def __call__(self) -> float:
        return self.now_s


@pytest.fixture
def clock() -> ManualClock:
    return ManualClock()


@pytest.fixture
def recorder(store: Store, clock: ManualClock) -> RunRecorder:
    return RunRecorder(store, clock=clock, recorded=RECORDED, urgent=URGENT)


@pytest.fixture
def run(store: Store, start: RunStart) -> RunRow:
    return store.runs.begin(start)


def test_a_run_knows_all_that_is_needed_to_do_it_again(
    store: Store, run: RunRow, group: GroupRow, version: VersionRow
) -> None:
    row = store.runs.get(run.id)
    assert (row.group_id, row.version_id, row.program_name) == (group.id, version.id, "Quadrado")
    assert (row.link, row.world, row.world_document, row.seed) == ("sim", "empty_room", WORLD, 7)
    assert (row.state, row.ended_at, row.app_version, row.path) == ("running", None, "0.1.0", [])


def test_a_run_of_the_command_line_keeps_its_document_instead_of_a_version(store: Store) -> None:
    start = RunStart(
        link="sim",
        world="w",
        world_document={},
        seed=0,
        app_version="1",
        document=SQUARE,
        parameters={"pace": "max"},
    )
    row = store.runs.begin(start)
    assert (row.group_id, row.program_id, row.version_id) == (None, None, None)
    assert row.program_name == "square"
    assert (row.document, row.parameters) == (SQUARE, {"pace": "max"})


def test_a_recorded_run_reads_back_as_it_was(
    store: Store, run: RunRow, recorder: RunRecorder, clock: ManualClock
) -> None:
    samples = list(square(run.id))
    recorder(block_started(run.id, seq=0))
    for event in samples:
        clock.now_s = event["tick"] / 30
        recorder({**event, "seq": event["tick"] + 1})
    end = ended(run.id, seq=len(samples) + 1, tick=len(samples))
    recorder(end)
    row = store.runs.get(run.id)
    assert (row.state, row.n_executed, row.closing_error_m) == ("finished", 8, 0.00005)
    assert row.estimated_closing_error_m == 0.00002
    assert row.duration_s == len(samples) / 30
    assert len(row.path) == 5
    assert store.runs.events(run.id) == [block_started(run.id, seq=0), end]
    telemetry = store.runs.telemetry(run.id)
    assert telemetry.column("tick").tolist() == list(range(len(samples)))
    assert np.allclose(
        telemetry.column("x_m"), [event["x_m"] for event in samples], atol=0.00005001
    )


@pytest.mark.parametrize("forged", ['"0"', "true", "1e999", "{}", "null"])
def test_of_an_estimate_that_is_no_number_nothing_is_read(
    store: Store, run: RunRow, recorder: RunRecorder, forged: str
) -> None:
    recorder(ended(run.id, seq=0, tick=0))
    text = f'{{"estimated_closing_error_m": {forged}}}'
    store.runs._database.write(lambda db: db.execute("UPDATE runs SET summary = ?", [text]))
    (line,) = store.runs.newest(1)
    assert line.estimated_closing_error_m is None


def test_what_sensors_measured_for_those_who_watched_is_not_kept_and_pushed_boxes_are(
    store: Store, run: RunRow, recorder: RunRecorder
) -> None:
    head = {"v": 1, "run": run.id, "tick": 3}
    boxes_event = {**head, "seq": 1, "type": "things", "boxes": {"0": [1.0, 2.0, 0.5]}}
    recorder(block_started(run.id, seq=0))
    recorder(boxes_event)
    recorder({**head, "seq": 2, "type": "ranges", "sonar": [1.0] * 16, "lidar": None})
    recorder.flush().result()
    assert store.runs.events(run.id) == [block_started(run.id, seq=0), boxes_event]


def test_telemetry_is_written_about_once_a_second(
    store: Store, run: RunRow, recorder: RunRecorder, clock: ManualClock, path: Path
) -> None:
    for event in list(square(run.id))[:300]:
        clock.now_s = event["tick"] / 30
        recorder(event)
    recorder.flush().result()
    with sqlite3.connect(path) as db:
        sizes = [row[0] for row in db.execute("SELECT n_rows FROM telemetry ORDER BY chunk")]
    db.close()
    assert sum(sizes) == 300
    assert all(29 <= size <= 31 for size in sizes[:-1])


def test_a_pause_is_written_at_once_because_nothing_may_follow(
    store: Store, run: RunRow, recorder: RunRecorder
) -> None:
    pause = {"v": 1, "type": "run_state", "run": run.id, "seq": 0, "tick": 0, "state": "paused"}
    recorder(pause)
    recorder.flush().result()
    assert store.runs.events(run.id) == [pause]


def test_a_run_that_failed_says_why_and_where(
    store: Store, run: RunRow, recorder: RunRecorder
) -> None:
    recorder(
        ended(run.id, 0, 60, state="failed", reason="blocked", block="kL0p", params={"seconds": 2})
    )
    row = store.runs.get(run.id)
    assert (row.state, row.reason, row.block, row.params) == (
        "failed",
        "blocked",
        "kL0p",
        {"seconds": 2},
    )


def test_two_runs_after_each_other_do_not_mix(
    store: Store, run: RunRow, start: RunStart, recorder: RunRecorder
) -> None:
    second = store.runs.begin(start)
    for row, n in ((run, 3), (second, 5)):
        for tick in range(n):
            recorder(sample(row.id, tick))
        recorder(ended(row.id, n, n))
    assert [len(store.runs.telemetry(row.id).rows) for row in (run, second)] == [3, 5]


def test_pages_of_runs_follow_each_other_without_gap(
    store: Store, start: RunStart, group: GroupRow
) -> None:
    ids = [store.runs.begin(start).id for _ in range(7)]
    first = store.runs.of_group(group.id, limit=3)
    second = store.runs.of_group(group.id, before=first[-1].id, limit=3)
    third = store.runs.of_group(group.id, before=second[-1].id, limit=3)
    assert [row.id for row in first + second + third] == ids[::-1]
    assert [row.id for row in store.runs.newest(2)] == [ids[6], ids[5]]


def test_a_run_is_found_by_the_beginning_of_its_id(store: Store, run: RunRow) -> None:
    assert store.runs.ids_beginning_with(run.id[:20]) == [run.id]
    assert store.runs.ids_beginning_with("%") == []


def test_a_run_that_could_not_begin_leaves_nothing(store: Store, run: RunRow) -> None:
    store.runs.discard(run.id)
    with pytest.raises(StoreError, match="run_not_found"):
        store.runs.get(run.id)


def test_an_interrupted_run_is_closed_with_what_was_recorded(
    store: Store, run: RunRow, recorder: RunRecorder, opened: Callable[..., Store]
) -> None:
    recorder(block_started(run.id, seq=0))
    for event in list(square(run.id))[:90]:
        recorder({**event, "seq": event["tick"] + 1})
    recorder.flush().result()
    reopened = opened(close_interrupted=True)
    row = reopened.runs.get(run.id)
    assert (row.state, row.reason, row.n_executed) == ("failed", "interrupted", None)
    assert row.duration_s == pytest.approx(89 / 30)
    assert row.path[0] == [0, 0]
    assert len(reopened.runs.telemetry(run.id).rows) == 90
    first, last = reopened.runs.events(run.id)
    assert first["type"] == "block_started"
    assert (last["type"], last["seq"], last["tick"], last["reason"]) == (
        "run_ended",
        91,
        89,
        "interrupted",
    )


def test_the_end_of_an_interrupted_run_has_the_fields_of_every_end(
    run: RunRow, opened: Callable[..., Store]
) -> None:
    (end,) = opened(close_interrupted=True).runs.events(run.id)
    expected = EventSequencer(run.id).wire(0, RunEnded.interrupted("interrupted", 0.0))
    assert expected.pop("estimated_closing_error_m") is None  # absent where it is not known
    assert end == expected


def test_another_program_that_opens_the_file_leaves_live_runs_alone(
    run: RunRow, opened: Callable[..., Store]
) -> None:
    assert opened().runs.get(run.id).state == "running"


def test_what_comes_of_a_run_that_is_gone_does_not_keep_others_waiting(
    store: Store, start: RunStart, run: RunRow, recorder: RunRecorder
) -> None:
    recorder(sample(run.id, 0))
    store._database.write(lambda db: purge_keys(db, [run.id]))
    recorder({"v": 1, "type": "said", "run": run.id, "seq": 1, "tick": 1, "text": "x"})
    recorder(ended(run.id, 2, 1))
    next_run = store.runs.begin(start)
    recorder(ended(next_run.id, 0, 0))
    assert recorder.problem is None
    assert store.runs.get(next_run.id).state != "running"
    assert [row.id for row in store.runs.newest(5)] == [next_run.id]


def test_a_batch_written_twice_is_the_same(
    store: Store, run: RunRow, recorder: RunRecorder
) -> None:
    recorder(block_started(run.id, seq=0))
    recorder.flush().result()
    recorder(ended(run.id, 1, 0))
    recorder(ended(run.id, 1, 0))
    assert [event["seq"] for event in store.runs.events(run.id)] == [0, 1]
