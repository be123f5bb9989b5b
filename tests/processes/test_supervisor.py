"""A supervised process: what is sent to it arrives, requests end in any case, and one that hangs holds up nobody."""

import sys
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import psutil
import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.processes import supervisor as supervision
from pinel_desktop.processes.heartbeat import HangTimeouts
from pinel_desktop.processes.outbox import MAX_WAITING
from pinel_desktop.processes.supervisor import Supervisor
from tests.in_time import in_time

WAIT_S = 30.0
READY = 'print(\'{"type": "some_ready"}\', flush=True)'
UNRESPONSIVE = f"import time; {READY}; time.sleep(600)"
ECHO = f"import sys; {READY}\nfor line in sys.stdin: sys.stdout.write(line)"


# it answers requests with their own `what`, refuses one without it, dies of "die" and hangs at "hang"
RESPONDER = f"""import json, sys, time; {READY}
for line in sys.stdin:
    asked = json.loads(line)
    if asked.get("what") == "die": sys.exit()
    if asked.get("what") == "hang": time.sleep(600)
    if asked.get("what") == "work": print('{{"type": "works"}}', flush=True)
    if asked.get("what") in ("nothing", "work") or "request" not in asked: continue
    found = {{"value": asked["what"]}} if "what" in asked else {{"code": "refused", "params": {{"n": 1}}}}
    print(json.dumps({{"type": "response", "request": asked["request"], **found}}), flush=True)
"""
QUICK = HangTimeouts(hang_timeout_s=0.4, busy_timeout_s=0.4, beat_s=0.1)
NEVER = HangTimeouts(beat_s=3600.0)  # it is not probed


def ignore(message: dict[str, Any]) -> None:
    """Nobody listens."""


def process(
    script: str,
    on_message: Callable[[dict[str, Any]], None] = ignore,
    timeouts: HangTimeouts = NEVER,
) -> Supervisor:
    command = [sys.executable, "-c", script]
    made = Supervisor("some", command, "some_lost", on_message=on_message, timeouts=timeouts)
    made.start()
    assert made.wait_until_ready(WAIT_S)
    return made


def test_all_that_was_sent_arrives_in_order_before_the_process_ends() -> None:
    received: list[dict[str, Any]] = []
    supervisor = process(ECHO, received.append)
    for n in range(500):
        supervisor.send({"n": n})
    supervisor.close()
    assert received == [{"n": n} for n in range(500)]


def replaced(supervisor: Supervisor, first: int | None) -> bool:
    due_s = time.monotonic() + WAIT_S
    while supervisor.pid == first and time.monotonic() < due_s:
        threading.Event().wait(0.02)
    return supervisor.pid != first


def test_process_that_hangs_and_does_not_read_holds_up_nobody_and_is_replaced() -> None:
    supervisor = process(UNRESPONSIVE, timeouts=QUICK)
    first, start_s = supervisor.pid, time.monotonic()
    supervisor.send({"much": "a" * 10_000_000})
    assert in_time(time.monotonic() - start_s, 1.0)
    assert replaced(supervisor, first)
    supervisor.close()


def test_starting_a_process_that_runs_changes_nothing() -> None:
    supervisor = process(ECHO)
    first = supervisor.pid
    supervisor.start()
    assert supervisor.pid == first
    supervisor.close()


def test_who_waits_for_a_process_that_is_closed_while_it_starts_goes_on() -> None:
    command = [sys.executable, "-c", "input()"]  # it never says that it is ready
    supervisor = Supervisor("some", command, "some_lost")
    supervisor.start()
    answers: list[bool] = []
    waiting = threading.Thread(target=lambda: answers.append(supervisor.wait_until_ready(60)))
    waiting.start()
    supervisor.close()
    waiting.join(WAIT_S)
    assert answers == [False]
    assert supervisor.wait_until_ready(60) is False


def test_who_waits_while_a_process_is_being_replaced_waits_for_the_next_one() -> None:
    answers: list[bool] = []
    waiting = threading.Thread(target=lambda: answers.append(supervisor.wait_until_ready(WAIT_S)))

    def on_death() -> None:
        waiting.start()
        waiting.join(0.3)

    command = [sys.executable, "-c", RESPONDER]
    supervisor = Supervisor("some", command, "some_lost", on_death=on_death, timeouts=NEVER)
    supervisor.start()
    assert supervisor.wait_until_ready(WAIT_S)
    first = supervisor.pid
    supervisor.send({"what": "die"})
    assert replaced(supervisor, first)
    waiting.join(WAIT_S)
    assert answers == [True]
    supervisor.close()


class IdleHarness:
    """A process with an idle timeout of 100 s on a clock that the test sets; it is probed often."""

    def __init__(self) -> None:
        self.now_s, self.n_asked = 0.0, 0
        self.deaths: list[str] = []
        self.works = threading.Event()
        command = [sys.executable, "-c", RESPONDER]
        self.supervisor = Supervisor(
            "some",
            command,
            "some_lost",
            on_message=lambda message: self.works.set(),
            on_death=lambda: self.deaths.append("died"),
            timeouts=HangTimeouts(beat_s=0.02),
            idle_end_s=100.0,
            clock=self._clock,
        )
        self.begin()

    def begin(self) -> None:
        self.supervisor.start()
        assert self.supervisor.wait_until_ready(WAIT_S)

    def pass_time(self, seconds: float) -> None:
        """Lets the time pass at once, and waits until the process was probed after that."""
        self.now_s += seconds
        asked = self.n_asked
        wait_for(lambda: self.n_asked >= asked + 3)

    def _clock(self) -> float:
        """Each probe reads the clock once."""
        self.n_asked += 1
        return self.now_s


@pytest.fixture
def idle() -> Iterator[IdleHarness]:
    made = IdleHarness()
    yield made
    made.supervisor.close()


def test_idle_process_ends_in_order_and_the_next_start_starts_another(idle: IdleHarness) -> None:
    first = idle.supervisor.pid
    idle.now_s = 100.0
    wait_for(lambda: idle.supervisor.pid is None)
    assert idle.supervisor.state == "starting"
    with pytest.raises(PinelError, match="some_lost"):
        idle.supervisor.request({"what": 1}, WAIT_S)
    idle.begin()
    assert idle.supervisor.pid not in (None, first)
    assert idle.supervisor.request({"what": 1}, WAIT_S) == 1
    assert idle.deaths == []


def test_process_in_use_does_not_end(idle: IdleHarness) -> None:
    first = idle.supervisor.pid
    for use in (
        idle.supervisor.start,
        idle.supervisor.mark_used,
        lambda: idle.supervisor.request({"what": 1}, WAIT_S),
    ):
        idle.pass_time(99.0)
        use()
    idle.pass_time(99.0)
    assert (idle.supervisor.pid, idle.supervisor.state) == (first, "ready")


def test_process_that_works_on_a_request_does_not_end(idle: IdleHarness) -> None:
    first = idle.supervisor.pid

    def ask() -> None:
        with pytest.raises(PinelError):
            idle.supervisor.request({"what": "work"}, WAIT_S)

    asking = threading.Thread(target=ask)
    asking.start()
    assert idle.works.wait(WAIT_S)
    idle.pass_time(1000.0)
    assert idle.supervisor.pid == first
    idle.supervisor.close()
    asking.join(WAIT_S)


def test_idle_process_that_does_not_end_is_replaced_by_the_next_start() -> None:
    """It reads nothing, so that the end of its input does not end it."""
    now_s = [0.0]
    supervisor = Supervisor(
        "some",
        [sys.executable, "-c", UNRESPONSIVE],
        "some_lost",
        timeouts=HangTimeouts(hang_timeout_s=60.0, busy_timeout_s=60.0, beat_s=0.02),
        idle_end_s=100.0,
        clock=lambda: now_s[0],
    )
    supervisor.start()
    assert supervisor.wait_until_ready(WAIT_S)
    first = supervisor.pid
    assert first is not None
    now_s[0] = 100.0
    wait_for(lambda: supervisor.pid is None)
    assert psutil.pid_exists(first)
    supervisor.start()
    assert supervisor.wait_until_ready(WAIT_S)
    assert supervisor.pid != first
    wait_for(lambda: not psutil.pid_exists(first))
    supervisor.close()


def wait_for(holds: Callable[[], object]) -> None:
    due_s = time.monotonic() + WAIT_S
    while not holds():
        assert time.monotonic() < due_s
        threading.Event().wait(0.02)


def lost(command: list[str]) -> list[str]:
    """What is told of a process that cannot live, until it is not started again."""
    events: list[str] = []
    supervisor = Supervisor(
        "some",
        command,
        "some_lost",
        on_death=lambda: events.append("died"),
        on_lost=lambda: events.append("lost"),
    )
    supervisor.start()
    assert not supervisor.wait_until_ready(WAIT_S)
    assert supervisor.state == "lost"
    supervisor.close()
    return events


def test_process_that_dies_three_times_soon_after_its_start_is_reported_as_lost(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(
        supervision, "_MIN_UPTIME_S", WAIT_S
    )  # on a busy PC Python itself starts slowly
    assert lost([sys.executable, "-c", ""]) == ["died", "died", "died", "lost"]


def test_process_that_cannot_be_started_is_reported_as_lost() -> None:
    assert lost(["/nowhere/some"]) == ["lost"]


def test_a_process_that_does_not_read_takes_only_so_much_and_the_rest_is_refused_at_once() -> None:
    supervisor = process(UNRESPONSIVE)
    line, start_s = {"much": "a" * 1_000}, time.monotonic()
    accepted = [supervisor.send(line) for _ in range(50_000)]
    assert time.monotonic() - start_s < WAIT_S
    assert (
        MAX_WAITING - 2_000 < 1_012 * sum(accepted) < MAX_WAITING + 200_000
    )  # with what the pipe holds
    assert not accepted[-1]
    supervisor.close()


def test_a_long_message_is_taken_where_nothing_waits() -> None:
    supervisor = process(ECHO)
    assert supervisor.send({"much": "a" * 2 * MAX_WAITING})
    supervisor.close()


def code_of(supervisor: Supervisor, timeout_s: float = WAIT_S, **message: Any) -> str:
    with pytest.raises(PinelError) as caught:
        supervisor.request(message, timeout_s)
    return caught.value.code


def test_a_request_gives_the_value_of_its_response_or_raises_what_is_answered() -> None:
    supervisor = process(RESPONDER)
    assert [supervisor.request({"what": n}, WAIT_S) for n in (1, "two", None)] == [1, "two", None]
    assert code_of(supervisor) == "refused"
    supervisor.close()


def test_a_request_without_a_response_ends_after_its_time_and_the_process_lives_on() -> None:
    supervisor = process(RESPONDER)
    first = supervisor.pid
    with pytest.raises(TimeoutError):
        supervisor.request({"what": "nothing"}, 0.2)
    assert supervisor.request({"what": 1}, WAIT_S) == 1
    assert supervisor.pid == first
    supervisor.close()


@pytest.mark.parametrize(("what", "timeouts"), [("die", NEVER), ("hang", QUICK)])
def test_requests_to_a_process_that_dies_or_hangs_end_with_it(
    what: str, timeouts: HangTimeouts
) -> None:
    supervisor = process(RESPONDER, timeouts=timeouts)
    first = supervisor.pid
    assert code_of(supervisor, what=what) == "some_lost"
    assert replaced(supervisor, first)
    supervisor.close()


def test_requests_end_when_the_process_is_closed_and_none_is_taken_afterwards() -> None:
    supervisor = process(RESPONDER)
    codes: list[str] = []
    asking = threading.Thread(target=lambda: codes.append(code_of(supervisor, what="nothing")))
    asking.start()
    while not supervisor._requests:
        threading.Event().wait(0.01)
    supervisor.close()
    asking.join(WAIT_S)
    assert codes == ["some_lost"]
    assert code_of(supervisor, what=1) == "some_lost"


def test_a_request_to_a_process_that_is_not_ready_is_refused_at_once() -> None:
    supervisor = Supervisor("some", [sys.executable, "-c", "input()"], "some_lost")
    supervisor.start()
    assert code_of(supervisor, what=1) == "some_lost"
    supervisor.close()
