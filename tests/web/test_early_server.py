"""While the app is being imported, the server serves the page to authorised requests; all other requests wait."""

import threading
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.messages import LANGUAGES
from pinel_desktop.settings import Settings
from pinel_desktop.web.early_server import EarlyServer


@pytest.fixture
def server() -> Iterator[EarlyServer]:
    server = EarlyServer()
    yield server
    server.close()


@pytest.fixture
def opener() -> urllib.request.OpenerDirector:
    return urllib.request.build_opener(urllib.request.HTTPCookieProcessor())


def app(environ: dict[str, Any], start_response: Any) -> list[bytes]:
    start_response("200 OK", [("Content-Type", "text/plain")])
    return [f"the app: {environ['PATH_INFO']}".encode()]


def test_the_page_is_there_at_once_with_the_same_protection(
    server: EarlyServer, opener: urllib.request.OpenerDirector
) -> None:
    with opener.open(server.guard.fresh_link(), timeout=20) as answer:
        assert b"<script" in answer.read()
        assert "default-src 'self'" in answer.headers["Content-Security-Policy"]
        assert "key=" not in answer.url


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_has_the_texts_of_the_language_that_it_last_spoke(
    opener: urllib.request.OpenerDirector, tmp_path: Path, language: str
) -> None:
    Settings.beside(tmp_path / "pinel.db").choose("pinel_language", language)
    settings = Settings.beside(tmp_path / "pinel.db")
    with (
        closing(EarlyServer(settings=settings)) as server,
        opener.open(server.guard.fresh_link(), timeout=20) as answer,
    ):
        assert f'<html lang="{language}" '.encode() in answer.read()


def test_the_page_is_there_at_once_with_its_settings(
    opener: urllib.request.OpenerDirector, tmp_path: Path
) -> None:
    chosen = Settings.beside(tmp_path / "pinel.db")
    chosen.choose("pinel_theme", "dark")
    chosen.choose("pinel_language", "es")
    server = EarlyServer(settings=Settings.beside(tmp_path / "pinel.db"))
    try:
        with opener.open(server.guard.fresh_link(), timeout=20) as answer:
            start = answer.read().split(b"<head>")[0].decode()
        assert 'lang="es"' in start
        assert 'data-theme="dark"' in start
        assert "&quot;pinel_theme&quot;: &quot;dark&quot;" in start
    finally:
        server.close()


def test_a_key_that_was_used_opens_nothing(
    server: EarlyServer, opener: urllib.request.OpenerDirector
) -> None:
    link = server.guard.fresh_link()
    opener.open(link, timeout=20).close()
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(link, timeout=20)
    refused.value.close()
    assert refused.value.code == 401


def test_questions_wait_for_the_app(
    server: EarlyServer, opener: urllib.request.OpenerDirector
) -> None:
    opener.open(server.guard.fresh_link(), timeout=20).close()
    answers: list[bytes] = []

    def ask() -> None:
        with opener.open(f"{server.guard.origin}/api/status", timeout=20) as answer:
            answers.append(answer.read())

    asking = threading.Thread(target=ask)
    asking.start()
    server.open(app)
    asking.join(20)
    assert answers == [b"the app: /api/status"]


def test_a_stranger_s_refusal_is_left_to_the_app(server: EarlyServer) -> None:
    server.open(app)
    with urllib.request.urlopen(server.guard.origin, timeout=20) as answer:
        assert answer.read().startswith(b"the app")


def test_an_app_that_never_comes_leaves_nobody_waiting(
    server: EarlyServer, opener: urllib.request.OpenerDirector
) -> None:
    opener.open(server.guard.fresh_link(), timeout=20).close()
    statuses: list[int] = []

    def ask() -> None:
        try:
            opener.open(f"{server.guard.origin}/api/status", timeout=20).close()
        except urllib.error.HTTPError as error:
            error.close()
            statuses.append(error.code)

    asking = threading.Thread(target=ask)
    asking.start()
    server.abandon()
    asking.join(20)
    assert statuses == [503]
