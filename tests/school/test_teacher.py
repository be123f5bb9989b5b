"""The teacher's PIN and sessions, on a simulated clock."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.school.teacher import IDLE_S, TeacherSessions
from storage import Store, open_store
from tests.attacks.pins import FullDisk

PIN, WRONG = "314159", "0000"
START_S = 1_800_000_000.0


class Clock:
    """A wall clock, which a test can set by `now_s`, and a monotonic clock."""

    def __init__(self) -> None:
        self.now_s = START_S
        self.steady_s = 0.0

    def __call__(self) -> float:
        return self.now_s

    def steady(self) -> float:
        return self.steady_s

    def passes(self, seconds: float) -> None:
        self.now_s += seconds
        self.steady_s += seconds


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    with open_store(tmp_path / "pinel.db") as store:
        yield store


@pytest.fixture
def sessions(store: Store, clock: Clock) -> TeacherSessions:
    sessions = TeacherSessions(store.settings, clock, clock.steady)
    sessions.set_pin(PIN)
    return sessions


def refusal(sessions: TeacherSessions, pin: str = WRONG) -> PinelError:
    with pytest.raises(PinelError) as refused:
        sessions.sign_in(pin)
    return refused.value


def fail(sessions: TeacherSessions, times: int) -> None:
    for _ in range(times):
        assert refusal(sessions).code == "pin_wrong"


def test_nobody_enters_before_there_is_a_pin(store: Store, clock: Clock) -> None:
    sessions = TeacherSessions(store.settings, clock, clock.steady)
    assert not sessions.has_pin
    assert refusal(sessions, PIN).code == "pin_missing"


def test_the_pin_is_not_to_be_read_in_the_file(sessions: TeacherSessions, store: Store) -> None:
    assert PIN not in str(store.settings.get("teacher_pin"))


def test_the_pin_signs_in_only_who_gave_it(sessions: TeacherSessions) -> None:
    token = sessions.sign_in(PIN)
    assert sessions.is_signed_in(token)
    for other in (None, "", "guessed", token[:-1]):
        assert not sessions.is_signed_in(other)


def test_signing_out_ends_one_session_only(sessions: TeacherSessions) -> None:
    one, other = sessions.sign_in(PIN), sessions.sign_in(PIN)
    sessions.sign_out(one)
    assert (sessions.is_signed_in(one), sessions.is_signed_in(other)) == (False, True)


def test_an_unused_session_ends(sessions: TeacherSessions, clock: Clock) -> None:
    token = sessions.sign_in(PIN)
    for _ in range(3):
        clock.passes(IDLE_S - 1)
        assert sessions.is_signed_in(token)
    clock.passes(IDLE_S + 1)
    assert not sessions.is_signed_in(token)
    clock.now_s -= 2
    assert not sessions.is_signed_in(token)


def test_a_clock_that_is_set_neither_ends_nor_prolongs_a_session(
    sessions: TeacherSessions, clock: Clock
) -> None:
    token = sessions.sign_in(PIN)
    clock.now_s -= 3600
    assert sessions.is_signed_in(token)
    clock.now_s += 7200
    assert sessions.is_signed_in(token)
    clock.steady_s += IDLE_S + 1
    clock.now_s -= 3600
    assert not sessions.is_signed_in(token)


def test_a_few_wrong_pins_cost_nothing_and_then_each_costs_twice_as_much(
    sessions: TeacherSessions, clock: Clock
) -> None:
    fail(sessions, 5)
    for wait_s in (30, 60, 120, 240, 480, 900, 900):
        waiting = refusal(sessions, PIN)
        assert waiting.code == "pin_wait"
        assert waiting.params["seconds"] in (wait_s, wait_s + 1)
        clock.passes(wait_s - 0.5)
        assert refusal(sessions, PIN).params["seconds"] == 1
        clock.passes(0.5)
        fail(sessions, 1)


def test_the_right_pin_after_the_wait_forgets_the_wrong_ones(
    sessions: TeacherSessions, clock: Clock
) -> None:
    fail(sessions, 5)
    clock.passes(30)
    assert sessions.is_signed_in(sessions.sign_in(PIN))
    fail(sessions, 5)


def test_starting_the_app_again_does_not_spare_the_wait(
    sessions: TeacherSessions, store: Store, clock: Clock
) -> None:
    fail(sessions, 5)
    again = TeacherSessions(store.settings, clock, clock.steady)
    assert refusal(again, PIN).code == "pin_wait"
    clock.passes(30)
    assert again.is_signed_in(again.sign_in(PIN))


def test_a_session_ends_when_the_app_ends(
    sessions: TeacherSessions, store: Store, clock: Clock
) -> None:
    token = sessions.sign_in(PIN)
    assert not TeacherSessions(store.settings, clock, clock.steady).is_signed_in(token)


@pytest.mark.parametrize("set_by_s", [-10 * 365 * 86_400, -20, 20, 86_400])
def test_setting_the_clock_neither_spares_the_wait_nor_makes_it_longer(
    sessions: TeacherSessions, clock: Clock, set_by_s: float
) -> None:
    fail(sessions, 5)
    clock.now_s += set_by_s
    assert refusal(sessions, PIN).params["seconds"] in (30, 31)
    clock.passes(29)
    assert refusal(sessions, PIN).code == "pin_wait"
    clock.passes(1)
    assert sessions.is_signed_in(sessions.sign_in(PIN))


def test_a_clock_set_back_far_before_a_start_does_not_keep_a_teacher_out(
    sessions: TeacherSessions, store: Store, clock: Clock
) -> None:
    fail(sessions, 5)
    clock.now_s -= 10 * 365 * 86_400
    clock.passes(5)
    again = TeacherSessions(store.settings, clock, clock.steady)
    assert refusal(again, PIN).params["seconds"] in (30, 31)
    clock.passes(30)
    assert again.is_signed_in(again.sign_in(PIN))


@pytest.mark.usefixtures("sessions")
def test_the_teacher_enters_on_a_full_disk_where_guesses_are_counted_in_memory(
    store: Store, clock: Clock
) -> None:
    sessions = TeacherSessions(FullDisk(store.settings), clock, clock.steady)
    assert sessions.is_signed_in(sessions.sign_in(PIN))
    assert refusal(sessions).code == "pin_wrong"
    assert refusal(sessions, PIN).params["seconds"] in (120, 121)
    clock.passes(120)
    assert sessions.is_signed_in(sessions.sign_in(PIN))


def test_wrong_pins_of_one_browser_session_do_not_keep_the_teacher_out_of_another(
    sessions: TeacherSessions,
) -> None:
    for _ in range(5):
        with pytest.raises(PinelError, match="pin_wrong"):
            sessions.sign_in(WRONG, "pupils")
    with pytest.raises(PinelError, match="pin_wait"):
        sessions.sign_in(PIN, "pupils")
    assert sessions.is_signed_in(sessions.sign_in(PIN, "teacher"))


def test_ever_new_browser_sessions_guess_30_times_an_hour_also_across_starts(
    sessions: TeacherSessions, store: Store, clock: Clock
) -> None:
    tried, n = 0, 0
    while clock.steady_s < 3600:
        n += 1
        try:
            sessions.sign_in(WRONG, f"session {n}")
        except PinelError as refused:
            tried += refused.code == "pin_wrong"
        if n % 50 == 0:
            sessions = TeacherSessions(store.settings, clock, clock.steady)
        clock.passes(10)
    assert 10 + 20 <= tried <= 10 + 30
    with pytest.raises(PinelError) as waiting:
        sessions.sign_in(PIN, "teacher")
    assert waiting.value.params["seconds"] in range(1, 122)


def test_a_clock_set_forward_gives_no_more_guesses_after_a_start(
    sessions: TeacherSessions, store: Store, clock: Clock
) -> None:
    for n in range(10):
        with pytest.raises(PinelError, match="pin_wrong"):
            sessions.sign_in(WRONG, f"session {n}")
    clock.now_s += 86_400
    again = TeacherSessions(store.settings, clock, clock.steady)
    with pytest.raises(PinelError, match="pin_wait"):
        again.sign_in(WRONG, "another")


def test_another_pin_ends_all_sessions(sessions: TeacherSessions) -> None:
    token = sessions.sign_in(PIN)
    sessions.set_pin("2718")
    assert not sessions.is_signed_in(token)
    assert refusal(sessions, PIN).code == "pin_wrong"
    assert sessions.is_signed_in(sessions.sign_in("2718"))


def test_a_pin_chosen_beside_the_running_app_ends_its_sessions(
    sessions: TeacherSessions, store: Store, clock: Clock
) -> None:
    token = sessions.sign_in(PIN)
    TeacherSessions(store.settings, clock, clock.steady).set_pin(PIN)
    assert not sessions.is_signed_in(token)
    token = sessions.sign_in(PIN)
    TeacherSessions(store.settings, clock, clock.steady).remove_pin()
    assert not sessions.is_signed_in(token)
    assert not sessions.has_pin


def test_choosing_another_pin_ends_a_wait(sessions: TeacherSessions) -> None:
    fail(sessions, 5)
    sessions.set_pin("2718")
    assert sessions.is_signed_in(sessions.sign_in("2718"))


@pytest.mark.parametrize("pin", ["", "123", "12345a", "1" * 13, "１２３４", "-1234", "12 34"])
def test_what_is_no_pin_is_not_chosen(sessions: TeacherSessions, pin: str) -> None:
    with pytest.raises(PinelError) as refused:
        sessions.set_pin(pin)
    assert refused.value.code == "pin_format"
    assert sessions.is_signed_in(sessions.sign_in(PIN))


def test_a_guess_may_be_anything(sessions: TeacherSessions) -> None:
    for guess in ("", "\ud800", "x" * 100_000):
        assert refusal(sessions, guess).code == "pin_wrong"


def test_a_session_survives_many_requests_at_once(store: Store) -> None:
    sessions = TeacherSessions(store.settings)
    sessions.set_pin(PIN)
    token = sessions.sign_in(PIN)
    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(lambda _: sessions.is_signed_in(token), range(2000)))
