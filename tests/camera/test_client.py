"""The real camera process behind its client, looking at recordings of hands: a sign, nothing, and again."""

import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import psutil
import pytest

from pinel_desktop.camera import sample_recording
from pinel_desktop.camera.client import CameraClient, CameraState
from pinel_desktop.camera.landmark_sequence import read_landmark_sequence, write_landmark_sequence
from pinel_desktop.execution.inputs import Capture
from pinel_desktop.gestures.features import N_FEATURES
from pinel_desktop.gestures.training import moving_hands as hands
from pinel_desktop.processes.heartbeat import HangTimeouts
from tests.camera.moving_hands import movements, write_moving_hand
from tests.camera.moving_hands import packed as packed_movements
from tests.camera.taught_hands import packed, shown, write_unknown_hand
from tests.in_time import in_time

pytestmark = pytest.mark.waits

WAIT_S = 30.0
SLOW = "time.sleep(2.5); say('camera_ready'); time.sleep(0.8)"
RECORDINGS = Path(__file__).parent / "recordings"


class Harness:
    """A camera with what it told in queues."""

    def __init__(self, source: str = str(RECORDINGS / "b.npz"), **options: Any) -> None:
        self.events: queue.Queue[dict[str, Any]] = queue.Queue()
        self.states: queue.Queue[CameraState] = queue.Queue()
        self.answers: queue.Queue[tuple[str, Capture]] = queue.Queue()
        self.camera = CameraClient(
            source,
            self.events.put,
            self.states.put,
            lambda run, capture: self.answers.put((run, capture)),
            **options,
        )

    def number(self) -> dict[str, Any]:
        """The next number that is told; null without a capture of one."""
        while not (number := self.events.get(timeout=WAIT_S)["number"]):
            pass
        return dict(number)

    def event(self, kind: str, **fields: Any) -> None:
        self.camera.observe({"type": kind, "run": "r", **fields})

    def until(self, mode: str) -> CameraState:
        while True:
            state = self.states.get(timeout=WAIT_S)
            if state.mode == mode:
                return state


def talking(script: str, then: str = "") -> list[str]:
    """A process in place of the camera's: says what a script says, then the same thing again and again."""
    head = "import json, sys, time; say = lambda kind, **more: print(json.dumps({'type': kind, **more}), flush=True)"
    tail = f"while True: time.sleep(0.1); say({then!r})" if then else ""
    return [sys.executable, "-c", f"{head}\n{script}\n{tail}"]


@pytest.fixture
def harness() -> Iterator[Harness]:
    made = Harness()
    yield made
    made.camera.close()


def wait_for(holds: Callable[[], object]) -> None:
    deadline = time.monotonic() + WAIT_S
    while not holds():
        assert time.monotonic() < deadline
        threading.Event().wait(0.02)


def test_capture_is_answered_with_what_is_shown_and_how_sure_that_is(harness: Harness) -> None:
    for expected in ("B", "A"):
        harness.camera.set_source(str(RECORDINGS / f"{expected.lower()}.npz"))
        harness.event("capture_started")
        run, capture = harness.answers.get(timeout=WAIT_S)
        harness.event("gesture_result")
        assert (run, capture.label, capture.by) == ("r", expected, "camera")
        assert capture.confidence is not None
        assert 0.5 < capture.confidence <= 1.0
        assert capture.second not in ("", expected)


@pytest.mark.parametrize(("letter", "number"), [("a", "0"), ("l", "2"), ("w", "3"), ("b", "4")])
def test_capture_of_a_number_is_answered_with_the_raised_fingers(
    harness: Harness, letter: str, number: str
) -> None:
    harness.camera.set_source(str(RECORDINGS / f"{letter}.npz"))
    harness.event("capture_started", what="number")
    shown = harness.number()
    run, capture = harness.answers.get(timeout=WAIT_S)
    assert (run, capture.label, capture.by) == ("r", number, "camera")
    assert set(shown) == {"best", "confidence", "second", "sure", "progress"}


def test_capture_of_a_number_is_answered_with_a_number_that_the_class_taught(
    harness: Harness,
) -> None:
    harness.camera.set_taught_signs((("7", packed(shown("L")), b""),))
    harness.camera.set_source(str(RECORDINGS / "l.npz"))
    harness.event("capture_started", what="number")
    capture = harness.answers.get(timeout=WAIT_S)[1]
    assert (capture.label, capture.by) == ("7", "taught")


def test_capture_that_a_person_answers_is_not_answered_again(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")
    harness.event("capture_started")
    harness.event("gesture_result")
    with pytest.raises(queue.Empty):
        harness.answers.get(timeout=2.0)


def test_paused_run_takes_no_answer_until_it_goes_on(harness: Harness) -> None:
    harness.event("capture_started")
    harness.event("run_state", state="paused")
    with pytest.raises(queue.Empty):
        harness.answers.get(timeout=2.0)
    harness.event("run_state", state="running")
    assert harness.answers.get(timeout=WAIT_S)[1].label == "B"


def test_what_is_seen_is_told_at_most_ten_times_a_second_and_never_as_a_picture(
    harness: Harness,
) -> None:
    harness.camera.switch_on()
    first = harness.events.get(timeout=WAIT_S)
    start_s, n = time.monotonic(), 0
    while time.monotonic() - start_s < 2.0:
        event = harness.events.get(timeout=WAIT_S)
        steady, moved = {"label", "progress"}, {"moved", "moved_confidence"}
        assert set(event) == set(first) == {"type", "hands", "aspect", "number"} | steady | moved
        assert all(
            0.0 <= value <= 1.0 for hand in event["hands"] for p in hand["points"] for value in p
        )
        n += 1
    assert n <= 21


def test_preview_is_a_stream_of_pictures(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")  # a preview ends where none comes for a while
    pictures = harness.camera.previews()
    for _ in range(3):
        assert next(pictures).startswith(b"\xff\xd8\xff")
    pictures.close()


def test_process_starts_without_the_camera_and_the_camera_goes_off_after_its_last_use() -> None:
    harness = Harness(idle_off_s=0.5)
    harness.camera.start()
    assert harness.camera.wait_until_ready(WAIT_S)
    assert harness.camera.state.mode == "off"
    harness.camera.switch_on()
    harness.until("on")
    harness.until("off")
    harness.camera.close()


def test_killed_process_is_told_and_the_next_one_answers_the_capture(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")
    wait_for(lambda: old_enough(harness.camera.pid))
    os.kill(harness.camera.pid or 0, signal.SIGKILL)
    harness.event("capture_started")
    problem = harness.until("failed").problem
    assert problem is not None
    assert problem.code == "camera_process_died"
    assert harness.answers.get(timeout=WAIT_S)[1].label == "B"


def test_process_that_hangs_is_replaced(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")
    wait_for(lambda: old_enough(harness.camera.pid))
    before = harness.camera.pid or 0
    os.kill(before, signal.SIGSTOP)
    harness.event("capture_started")
    assert harness.answers.get(timeout=WAIT_S)[1].label == "B"
    assert harness.camera.pid != before
    assert not psutil.pid_exists(before)


def test_process_that_hangs_while_the_camera_is_off_is_replaced_too(harness: Harness) -> None:
    harness.camera.start()
    assert harness.camera.wait_until_ready(WAIT_S)
    wait_for(lambda: old_enough(harness.camera.pid))
    before = harness.camera.pid or 0
    os.kill(before, signal.SIGSTOP)
    wait_for(lambda: harness.camera.pid != before)
    assert not psutil.pid_exists(before)


def test_process_that_hangs_before_the_camera_is_on_holds_up_nobody(harness: Harness) -> None:
    harness.camera.start()
    assert harness.camera.wait_until_ready(WAIT_S)
    wait_for(lambda: old_enough(harness.camera.pid))
    os.kill(harness.camera.pid or 0, signal.SIGSTOP)
    start_s = time.monotonic()
    hands = packed(shown("B")[:10])
    harness.camera.set_taught_signs((("B", 5 * hands, b""),))  # more than a pipe takes
    harness.event("capture_started")
    assert in_time(time.monotonic() - start_s, 1.0)
    assert harness.answers.get(timeout=WAIT_S)[1].by == "taught"


def test_process_that_is_slow_to_start_is_left_its_time() -> None:
    timeouts = HangTimeouts(hang_timeout_s=1.0, busy_timeout_s=1.0)
    harness = Harness(command=talking(SLOW, then="pong"), timeouts=timeouts)
    harness.camera.switch_on()
    assert harness.camera.wait_until_ready(WAIT_S)
    pid = harness.camera.pid
    threading.Event().wait(1.5)
    assert harness.camera.pid == pid
    harness.camera.close()


def test_process_that_never_starts_is_replaced() -> None:
    timeouts = HangTimeouts(start_timeout_s=0.5)
    harness = Harness(command=talking("time.sleep(600)"), timeouts=timeouts)
    harness.camera.switch_on()
    first = harness.camera.pid
    wait_for(lambda: harness.camera.pid != first)
    harness.camera.close()


def test_process_that_dies_at_once_is_told_and_stays_so_until_it_works(tmp_path: Path) -> None:
    repaired = tmp_path / "repaired"
    script = f"""
import pathlib
if not pathlib.Path({str(repaired)!r}).exists():
    sys.exit(1)
say('camera_ready')
say('camera_state', state='on', code=None, params={{}})"""
    harness = Harness(command=talking(script, then="pong"))
    harness.camera.switch_on()
    assert not harness.camera.wait_until_ready(WAIT_S)
    assert harness.camera.state.problem is not None
    assert harness.camera.state.problem.code == "camera_process_lost"
    states = [harness.states.get_nowait() for _ in range(4)]
    assert [state.problem and state.problem.code for state in states] == [
        *3 * ["camera_process_died"],
        "camera_process_lost",
    ]
    harness.camera.switch_on()
    assert not harness.camera.wait_until_ready(WAIT_S)
    assert harness.states.get_nowait().problem == harness.camera.state.problem
    repaired.touch()
    harness.camera.switch_on()
    assert harness.until("on").problem is None
    harness.camera.close()


def test_messages_that_are_none_are_passed_over() -> None:
    garbage = [
        "say('camera_ready')",
        *(f"say({kind!r})" for kind in ("camera_state", "sight", "recognised", "sample")),
        "say('preview', jpeg='?')",
        "say('camera_state', state='on', code=7, params=[])",
        "sys.stdout.write('[' * 200_000 + chr(10))",
        "say('camera_state', state='on', code=None, params={})",
    ]
    harness = Harness(command=talking("; ".join(garbage), then="pong"))
    harness.camera.switch_on()
    harness.event("capture_started")
    assert harness.until("on").problem is None
    harness.camera.close()


def test_an_order_that_is_none_is_passed_over(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")
    pid = harness.camera.pid
    for order in (
        {},
        {"type": "desired_state"},
        {"type": "signs"},
        {"type": "signs", "signs": [{}]},
    ):
        harness.camera._process.send(order)
    harness.event("capture_started")
    assert harness.answers.get(timeout=WAIT_S)[1].label == "B"
    assert harness.camera.pid == pid


def test_one_who_leaves_takes_the_picture_from_nobody(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")
    leaving, staying = harness.camera.previews(), harness.camera.previews()
    assert next(leaving)
    assert next(staying)
    leaving.close()
    for _ in range(3):
        assert next(staying)
    staying.close()


def test_source_that_cannot_be_opened_is_told_and_another_can_be_chosen(harness: Harness) -> None:
    harness.camera.set_source("9")
    harness.event("capture_started")
    problem = harness.until("failed").problem
    assert problem is not None
    assert problem.code == "camera_missing"
    harness.camera.set_source(str(RECORDINGS / "b.npz"))
    assert harness.answers.get(timeout=WAIT_S)[1].label == "B"


def test_closing_ends_process_and_previews_within_two_seconds(harness: Harness) -> None:
    harness.camera.switch_on()
    harness.until("on")
    pictures = harness.camera.previews()
    next(pictures)
    pid = harness.camera.pid or 0
    start_s = time.monotonic()
    harness.camera.close()
    assert list(pictures) == []
    assert in_time(time.monotonic() - start_s, 2.0)
    assert not psutil.pid_exists(pid)


def old_enough(pid: int | None) -> bool:
    """A process that dies soon after its start counts as one that cannot start."""
    return pid is not None and time.time() - psutil.Process(pid).create_time() > 3.2


class TestTeaching:
    def test_what_a_class_taught_answers_and_says_so(
        self, harness: Harness, tmp_path: Path
    ) -> None:
        unknown_hand = write_unknown_hand(tmp_path / "strange.npz")
        first = [hand for frame in read_landmark_sequence(unknown_hand)[:10] for hand in frame]
        harness.camera.set_taught_signs((("vai", packed(first), b""),))
        harness.camera.set_source(str(unknown_hand))
        harness.event("capture_started")
        _, capture = harness.answers.get(timeout=WAIT_S)
        assert (capture.label, capture.by) == ("vai", "taught")
        harness.camera.set_source(str(RECORDINGS / "b.npz"))
        harness.event("capture_started")
        _, capture = harness.answers.get(timeout=WAIT_S)
        assert (capture.label, capture.by) == ("B", "camera")

    def test_what_is_not_taught_any_more_is_not_answered(
        self, harness: Harness, tmp_path: Path
    ) -> None:
        harness.camera.set_taught_signs((("B", packed(shown("B")[:10]), b""),))
        harness.event("capture_started")
        assert harness.answers.get(timeout=WAIT_S)[1].by == "taught"
        harness.camera.set_taught_signs(())
        harness.event("capture_started")
        assert harness.answers.get(timeout=WAIT_S)[1].by == "camera"

    def test_the_process_that_takes_the_place_of_another_knows_it_too(
        self, harness: Harness
    ) -> None:
        harness.camera.set_taught_signs((("B", packed(shown("B")[:10]), b""),))
        harness.camera.switch_on()
        harness.until("on")
        wait_for(lambda: old_enough(harness.camera.pid))
        os.kill(harness.camera.pid or 0, signal.SIGKILL)
        harness.event("capture_started")
        assert harness.answers.get(timeout=WAIT_S)[1].by == "taught"

    def test_ten_hands_at_rest_are_recorded(self, harness: Harness) -> None:
        updates: queue.Queue[tuple[bytes, ...]] = queue.Queue()
        harness.camera.record(10, updates.put, lambda: updates.put(()))
        for n in range(1, 11):
            samples = updates.get(timeout=WAIT_S)
            assert len(samples) == n
        assert {len(sample) for sample in samples} == {2 * N_FEATURES}
        with pytest.raises(queue.Empty):
            updates.get(timeout=1.0)

    def test_a_recording_without_a_hand_is_given_up(
        self, harness: Harness, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        monkeypatch.setattr(sample_recording, "_TIMEOUT_S", 0.1)
        nobody = tmp_path / "nobody.npz"
        write_landmark_sequence(nobody, [None])
        harness.camera.set_source(str(nobody))
        stopped = threading.Event()
        harness.camera.record(10, lambda samples: None, stopped.set)
        assert stopped.wait(WAIT_S)


class TestSignsThatMove:
    MOTION = hands.letter_path("Z")

    def test_five_movements_are_recorded_and_then_answer(
        self, harness: Harness, tmp_path: Path
    ) -> None:
        harness.camera.set_source(
            str(write_moving_hand(tmp_path / "taught.npz", "B", self.MOTION, range(5)))
        )
        updates: queue.Queue[tuple[bytes, ...]] = queue.Queue()
        harness.camera.record(5, updates.put, lambda: updates.put(()), is_moving=True)
        for n in range(1, 6):
            samples = updates.get(timeout=WAIT_S)
            assert len(samples) == n
        assert {len(sample) for sample in samples} == {2 * N_FEATURES}
        harness.camera.set_taught_signs((("Z", b"", b"".join(samples)),))
        other = write_moving_hand(tmp_path / "other.npz", "B", self.MOTION, range(50, 54))
        harness.camera.set_source(str(other))
        harness.event("capture_started")
        _, capture = harness.answers.get(timeout=WAIT_S)
        assert (capture.label, capture.by) == ("Z", "taught")
        assert capture.confidence is not None
        assert 0.3 < capture.confidence <= 1.0

    def test_a_letter_at_rest_is_still_the_letter(self, harness: Harness) -> None:
        taught = packed_movements(movements("B", self.MOTION, range(5)))
        harness.camera.set_taught_signs((("Z", b"", taught),))
        harness.event("capture_started")
        _, capture = harness.answers.get(timeout=WAIT_S)
        assert (capture.label, capture.by) == ("B", "camera")


@pytest.fixture
def short_lived() -> Iterator[Harness]:
    made = Harness(idle_off_s=5.0, idle_end_s=2.0)
    yield made
    made.camera.close()


def test_process_ends_when_the_camera_was_off_for_a_while_and_the_next_capture_starts_it(
    short_lived: Harness,
) -> None:
    short_lived.camera.start()
    assert short_lived.camera.wait_until_ready(WAIT_S)
    wait_for(lambda: short_lived.camera.pid is None)
    short_lived.event("capture_started")
    _, capture = short_lived.answers.get(timeout=WAIT_S)
    short_lived.event("gesture_result")
    assert capture.label == "B"
    wait_for(lambda: short_lived.camera.pid is None)
    assert short_lived.camera.state == CameraState("off")


def test_process_stays_while_somebody_watches_the_picture(short_lived: Harness) -> None:
    short_lived.camera.switch_on()
    short_lived.until("on")
    pictures = short_lived.camera.previews()
    next(pictures)
    first, start_s = short_lived.camera.pid, time.monotonic()
    while time.monotonic() - start_s < 5.0:
        next(pictures)
    assert short_lived.camera.pid == first
    pictures.close()
    wait_for(lambda: short_lived.camera.pid is None)


def test_process_stays_during_a_run_that_may_capture_again(short_lived: Harness) -> None:
    short_lived.event("capture_started")
    short_lived.answers.get(timeout=WAIT_S)
    short_lived.event("gesture_result")
    first = short_lived.camera.pid
    short_lived.until("off")
    off_s = time.monotonic()
    while time.monotonic() - off_s < 5.0:
        short_lived.event("telemetry")
        threading.Event().wait(0.05)
    assert short_lived.camera.pid == first
    short_lived.event("run_ended")
    wait_for(lambda: short_lived.camera.pid is None)
