"""The window's navigation policy and size."""

import pytest

from pinel_desktop.desktop.policy import (
    MAX_RELOADS,
    ReloadLimit,
    decide_navigation,
    fitted_size,
    may_open,
)

OWN = "http://127.0.0.1:40123/?key=abc"


@pytest.mark.parametrize(
    "address", ["http://127.0.0.1:40123/", "http://127.0.0.1:40123/api/status?x=1#top"]
)
def test_our_own_page_may_open(address: str) -> None:
    assert may_open(address, OWN)


@pytest.mark.parametrize(
    "address",
    [
        "http://127.0.0.1:40124/",
        "https://127.0.0.1:40123/",
        "http://localhost:40123/",
        "http://127.0.0.1:40123@example.org/",
        "http://example.org/http://127.0.0.1:40123/",
        "http://127.0.0.1:999999/",
        "http://[broken",
        "file:///etc/passwd",
        "data:text/html,hello",
        "javascript:alert(1)",
        "about:blank",
        "",
    ],
)
def test_nothing_else_may_open(address: str) -> None:
    assert not may_open(address, OWN)


@pytest.mark.parametrize(
    ("address", "verdict"),
    [
        ("http://127.0.0.1:40123/", "show"),
        ("about:blank", "refuse"),
        ("blob:http://127.0.0.1:40123/fc63614a-e294", "save"),
        ("blob:http://127.0.0.1:40124/fc63614a-e294", "refuse"),
        ("blob:null/fc63614a-e294", "refuse"),
        ("data:text/html,hello", "refuse"),
        ("http://example.org/", "refuse"),
    ],
)
def test_files_that_the_page_hands_out_are_saved_and_not_shown(address: str, verdict: str) -> None:
    assert decide_navigation(address, OWN) == verdict


@pytest.mark.parametrize("screen", [(1366, 768), (1280, 1024), (1024, 768), (1440, 900)])
def test_a_small_screen_is_filled(screen: tuple[int, int]) -> None:
    size = fitted_size(*screen)
    assert size.maximized
    assert (size.width, size.height) == screen


def test_a_large_screen_keeps_room_around_the_window() -> None:
    size = fitted_size(1920, 1080)
    assert (size.width, size.height, size.maximized) == (1600, 918, False)


def test_the_window_may_never_be_larger_than_the_screen_asks_for() -> None:
    assert fitted_size(800, 600).min_size == (800, 600)


def test_a_page_that_dies_each_time_is_loaded_a_few_times_a_minute() -> None:
    limit = ReloadLimit()
    waits_s = [limit.next_wait_s(now_s) for now_s in (0.0, 5.0, 10.0, 15.0)]
    assert waits_s == [0.0] * MAX_RELOADS + [45.0]


def test_a_crash_that_is_noticed_several_times_loads_the_page_once() -> None:
    limit = ReloadLimit()
    assert [limit.next_wait_s(now_s) for now_s in (0.0, 0.1, 1.9)] == [0.0, None, None]


def test_a_page_that_dies_once_a_day_comes_back_each_time() -> None:
    limit = ReloadLimit()
    assert [limit.next_wait_s(86_400.0 * day) for day in range(10)] == [0.0] * 10
