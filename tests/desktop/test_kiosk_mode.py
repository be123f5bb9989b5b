"""The teacher's permission to print in kiosk mode."""

import pytest

from pinel_desktop.desktop.kiosk.mode import PRINT_PERMISSION_S, PrintPermission


class Clock:
    """A clock that a test sets."""

    def __init__(self) -> None:
        self.now_s = 1000.0

    def __call__(self) -> float:
        return self.now_s


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def permission(clock: Clock) -> PrintPermission:
    return PrintPermission(clock)


def test_nothing_is_printed_without_the_teacher(permission: PrintPermission) -> None:
    assert not permission.use()


def test_the_permission_is_for_one_print_dialog(permission: PrintPermission) -> None:
    permission.grant()
    assert permission.use()
    assert not permission.use()


def test_the_permission_ends_after_a_short_time(permission: PrintPermission, clock: Clock) -> None:
    permission.grant()
    clock.now_s += PRINT_PERMISSION_S
    assert not permission.use()


def test_a_second_permission_has_its_own_two_minutes(
    permission: PrintPermission, clock: Clock
) -> None:
    permission.grant()
    clock.now_s += PRINT_PERMISSION_S - 1
    permission.grant()
    clock.now_s += PRINT_PERMISSION_S - 1
    assert permission.use()
