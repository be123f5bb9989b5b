"""The delayed app (`late_app.py`), with which tests show missing waits."""

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
from typing import Any

import pytest

from tests.e2e.late_app import LateAnswers

PAGE = {"HTTP_SEC_FETCH_SITE": "same-origin"}


def delays(seed: str, requests: int, environ: dict[str, str]) -> list[float]:
    """Returns the delays of successive requests, before and after their processing."""
    slept: list[float] = []
    late = LateAnswers(lambda environ, start: [b""], seed, slept.append)
    for _ in range(requests):
        late(environ, None)
    return [slept[at] + slept[at + 1] for at in range(0, len(slept), 2)]


def test_each_request_of_the_page_is_late_by_another_time_of_its_seed() -> None:
    first = delays("1", 20, PAGE)
    assert all(0.2 <= one <= 0.6 for one in first)
    assert len(set(first)) == 20
    assert delays("1", 20, PAGE) == first
    assert delays("2", 20, PAGE) != first


def test_requests_of_the_tests_are_not_late() -> None:
    assert delays("1", 3, {}) == [0, 0, 0]


@pytest.mark.timeout(60)
def test_requests_wait_side_by_side() -> None:
    all_at_work = Barrier(8)

    def work(environ: dict[str, Any], start_response: Any) -> list[bytes]:
        all_at_work.wait()
        return [b"done"]

    late = LateAnswers(work, "1")
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(lambda _: late(PAGE, None), range(8))) == [[b"done"]] * 8
