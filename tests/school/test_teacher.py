"""The teacher's door, on a clock of the test's own."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.school.teacher import IDLE_S, Kept, TeacherDoor
from storage import Store, StoreError, open_store

PIN, WRONG = "314159", "0000"
START_S = 1_800_000_000.0


class Clock:
    """One that can be set, by `now_s`, and one that cannot."""

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
def door(store: Store, clock: Clock) -> TeacherDoor:
    door = TeacherDoor(store.settings, clock, clock.steady)
    door.choose(PIN)
    return door


def refusal(door: TeacherDoor, pin: str = WRONG) -> PinelError:
    with pytest.raises(PinelError) as refused:
        door.enter(pin)
    return refused.value


def fail(door: TeacherDoor, times: int) -> None:
    for _ in range(times):
        assert refusal(door).code == "pin_wrong"


def test_nobody_enters_before_there_is_a_pin(store: Store, clock: Clock) -> None:
    door = TeacherDoor(store.settings, clock, clock.steady)
    assert not door.has_pin
    assert refusal(door, PIN).code == "pin_missing"


def test_the_pin_is_not_to_be_read_in_the_file(door: TeacherDoor, store: Store) -> None:
    assert PIN not in str(store.settings.get("teacher_pin"))


def test_the_pin_opens_and_only_to_the_one_who_gave_it(door: TeacherDoor) -> None:
    token = door.enter(PIN)
    assert door.is_open(token)
    for other in (None, "", "guessed", token[:-1]):
        assert not door.is_open(other)


def test_another_token_is_not_shut_out_when_one_leaves(door: TeacherDoor) -> None:
    one, other = door.enter(PIN), door.enter(PIN)
    door.leave(one)
    assert (door.is_open(one), door.is_open(other)) == (False, True)


def test_an_open_door_shuts_when_nobody_uses_it(door: TeacherDoor, clock: Clock) -> None:
    token = door.enter(PIN)
    for _ in range(3):
        clock.passes(IDLE_S - 1)
        assert door.is_open(token)
    clock.passes(IDLE_S + 1)
    assert not door.is_open(token)
    clock.now_s -= 2
    assert not door.is_open(token)


def test_a_clock_that_is_set_neither_shuts_the_door_nor_keeps_it_open(
    door: TeacherDoor, clock: Clock
) -> None:
    token = door.enter(PIN)
    clock.now_s -= 3600
    assert door.is_open(token)
    clock.now_s += 7200
    assert door.is_open(token)
    clock.steady_s += IDLE_S + 1
    clock.now_s -= 3600
    assert not door.is_open(token)


def test_a_few_wrong_pins_cost_nothing_and_then_each_costs_twice_as_much(
    door: TeacherDoor, clock: Clock
) -> None:
    fail(door, 5)
    for wait_s in (30, 60, 120, 240, 480, 900, 900):
        waiting = refusal(door, PIN)
        assert waiting.code == "pin_wait"
        assert waiting.params["seconds"] in (wait_s, wait_s + 1)
        clock.passes(wait_s - 0.5)
        assert refusal(door, PIN).params["seconds"] == 1
        clock.passes(0.5)
        fail(door, 1)


def test_the_right_pin_after_the_wait_forgets_the_wrong_ones(
    door: TeacherDoor, clock: Clock
) -> None:
    fail(door, 5)
    clock.passes(30)
    assert door.is_open(door.enter(PIN))
    fail(door, 5)


def test_starting_the_app_again_does_not_spare_the_wait(
    door: TeacherDoor, store: Store, clock: Clock
) -> None:
    fail(door, 5)
    again = TeacherDoor(store.settings, clock, clock.steady)
    assert refusal(again, PIN).code == "pin_wait"
    clock.passes(30)
    assert again.is_open(again.enter(PIN))


def test_a_door_that_was_open_is_shut_after_a_start(
    door: TeacherDoor, store: Store, clock: Clock
) -> None:
    token = door.enter(PIN)
    assert not TeacherDoor(store.settings, clock, clock.steady).is_open(token)


@pytest.mark.parametrize("set_by_s", [-10 * 365 * 86_400, -20, 20, 86_400])
def test_setting_the_clock_neither_spares_the_wait_nor_makes_it_longer(
    door: TeacherDoor, clock: Clock, set_by_s: float
) -> None:
    fail(door, 5)
    clock.now_s += set_by_s
    assert refusal(door, PIN).params["seconds"] in (30, 31)
    clock.passes(29)
    assert refusal(door, PIN).code == "pin_wait"
    clock.passes(1)
    assert door.is_open(door.enter(PIN))


def test_a_clock_set_back_far_before_a_start_does_not_keep_a_teacher_out(
    door: TeacherDoor, store: Store, clock: Clock
) -> None:
    fail(door, 5)
    clock.now_s -= 10 * 365 * 86_400
    clock.passes(5)
    again = TeacherDoor(store.settings, clock, clock.steady)
    assert refusal(again, PIN).params["seconds"] in (30, 31)
    clock.passes(30)
    assert again.is_open(again.enter(PIN))


class FullDisk:
    """Settings of a full disk: they can be read."""

    def __init__(self, kept: Kept) -> None:
        self._kept = kept

    def get(self, key: str) -> Any:
        return self._kept.get(key)

    def set(self, key: str, value: object) -> None:
        raise StoreError("disk_full")


@pytest.mark.usefixtures("door")
def test_a_guess_that_cannot_be_counted_is_none(store: Store, clock: Clock) -> None:
    door = TeacherDoor(FullDisk(store.settings), clock, clock.steady)
    for pin in (PIN, WRONG):
        with pytest.raises(StoreError):
            door.enter(pin)


def test_another_pin_shuts_the_door_for_everybody(door: TeacherDoor) -> None:
    token = door.enter(PIN)
    door.choose("2718")
    assert not door.is_open(token)
    assert refusal(door, PIN).code == "pin_wrong"
    assert door.is_open(door.enter("2718"))


def test_a_pin_chosen_beside_the_running_app_shuts_its_door(
    door: TeacherDoor, store: Store, clock: Clock
) -> None:
    token = door.enter(PIN)
    TeacherDoor(store.settings, clock, clock.steady).choose(PIN)
    assert not door.is_open(token)
    token = door.enter(PIN)
    TeacherDoor(store.settings, clock, clock.steady).forget()
    assert not door.is_open(token)
    assert not door.has_pin


def test_choosing_another_pin_ends_a_wait(door: TeacherDoor) -> None:
    fail(door, 5)
    door.choose("2718")
    assert door.is_open(door.enter("2718"))


@pytest.mark.parametrize("pin", ["", "123", "12345a", "1" * 13, "１２３４", "-1234", "12 34"])
def test_what_is_no_pin_is_not_chosen(door: TeacherDoor, pin: str) -> None:
    with pytest.raises(PinelError) as refused:
        door.choose(pin)
    assert refused.value.code == "pin_format"
    assert door.is_open(door.enter(PIN))


def test_a_guess_may_be_anything(door: TeacherDoor) -> None:
    for guess in ("", "\ud800", "x" * 100_000):
        assert refusal(door, guess).code == "pin_wrong"


def test_the_door_stays_open_for_many_who_ask_at_once(store: Store) -> None:
    door = TeacherDoor(store.settings)
    door.choose(PIN)
    token = door.enter(PIN)
    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(lambda _: door.is_open(token), range(2000)))
