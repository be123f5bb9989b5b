"""Before the app is imported the server gives out the page, to who may have it, and makes all else wait."""

import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from typing import Any

import pytest

from pinel_desktop.web.front import Front


@pytest.fixture
def front() -> Iterator[Front]:
    front = Front()
    yield front
    front.close()


@pytest.fixture
def opener() -> urllib.request.OpenerDirector:
    return urllib.request.build_opener(urllib.request.HTTPCookieProcessor())


def app(environ: dict[str, Any], start_response: Any) -> list[bytes]:
    start_response("200 OK", [("Content-Type", "text/plain")])
    return [f"the app: {environ['PATH_INFO']}".encode()]


def test_the_page_is_there_at_once_with_the_same_protection(
    front: Front, opener: urllib.request.OpenerDirector
) -> None:
    with opener.open(front.guard.fresh_link(), timeout=20) as answer:
        assert b"<script" in answer.read()
        assert "default-src 'self'" in answer.headers["Content-Security-Policy"]
        assert "key=" not in answer.url


def test_a_key_that_was_used_opens_nothing(
    front: Front, opener: urllib.request.OpenerDirector
) -> None:
    link = front.guard.fresh_link()
    opener.open(link, timeout=20).close()
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(link, timeout=20)
    refused.value.close()
    assert refused.value.code == 401


def test_questions_wait_for_the_app(front: Front, opener: urllib.request.OpenerDirector) -> None:
    opener.open(front.guard.fresh_link(), timeout=20).close()
    answers: list[bytes] = []

    def ask() -> None:
        with opener.open(f"{front.guard.origin}/api/status", timeout=20) as answer:
            answers.append(answer.read())

    asking = threading.Thread(target=ask)
    asking.start()
    front.open(app)
    asking.join(20)
    assert answers == [b"the app: /api/status"]


def test_a_stranger_s_refusal_is_left_to_the_app(front: Front) -> None:
    front.open(app)
    with urllib.request.urlopen(front.guard.origin, timeout=20) as answer:
        assert answer.read().startswith(b"the app")


def test_an_app_that_never_comes_leaves_nobody_waiting(
    front: Front, opener: urllib.request.OpenerDirector
) -> None:
    opener.open(front.guard.fresh_link(), timeout=20).close()
    seen: list[int] = []

    def ask() -> None:
        try:
            opener.open(f"{front.guard.origin}/api/status", timeout=20).close()
        except urllib.error.HTTPError as error:
            error.close()
            seen.append(error.code)

    asking = threading.Thread(target=ask)
    asking.start()
    front.give_up()
    asking.join(20)
    assert seen == [503]
