"""Bounds on time of a quiet PC, on a busy one."""

import pytest

from tests.in_time import in_time


def test_on_a_quiet_pc_the_bound_is_the_bound() -> None:
    assert in_time(1.9, 2.0, lambda: 1.0)
    assert not in_time(2.1, 2.0, lambda: 1.0)


def test_on_a_busy_pc_it_is_as_many_times_longer_as_work_takes_there() -> None:
    assert in_time(19.0, 2.0, lambda: 10.0)
    assert not in_time(21.0, 2.0, lambda: 10.0)


def test_who_is_in_time_does_not_work_to_find_out_how_busy_the_pc_is() -> None:
    assert in_time(1.9, 2.0, lambda: pytest.fail("asked"))


def test_what_takes_for_ever_is_late_on_any_pc() -> None:
    assert not in_time(1e6, 1.0)
