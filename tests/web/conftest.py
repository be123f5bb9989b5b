"""Fixtures: the real app over HTTP on a real database, with a fake engine of the same interface."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

SQUARE: dict[str, Any] = {
    "pinel_ir": 1,
    "name": "square",
    "functions": [],
    "commands": [
        {
            "action": "repeat",
            "block": "r",
            "times": 4,
            "commands": [
                {"action": "move_forward", "block": "m", "distance": 1},
                {"action": "turn", "block": "t", "angle": 90},
            ],
        }
    ],
}


@pytest.fixture(autouse=True)
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PINEL_LANG", "en")


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "pinel.db"


@pytest.fixture
def start_app(database: Path) -> Iterator[Callable[..., App]]:
    """Starts apps with a fake engine and closes them at the end of the test."""
    with ExitStack() as stack:

        def start(path: Path = database, **options: Any) -> App:
            return stack.enter_context(App(path, **{"make_engine": FakeEngine, **options}))

        yield start


@pytest.fixture
def app(start_app: Callable[..., App]) -> App:
    return start_app()


@pytest.fixture
def engine(app: App) -> FakeEngine:
    found = app._engine
    assert isinstance(found, FakeEngine)
    return found


@pytest.fixture
def browser(app: App) -> Browser:
    """A browser that has opened the page."""
    return Browser.signed_in(app.address)


@pytest.fixture
def group(browser: Browser) -> Any:
    return browser.post("/api/groups", {"name": "Os Robôs"}).data


@pytest.fixture
def program(browser: Browser, group: dict[str, Any]) -> Any:
    return browser.post(f"/api/groups/{group['id']}/programs", {"name": "Quadrado"}).data


@pytest.fixture
def version(browser: Browser, program: dict[str, Any]) -> Any:
    return browser.post(
        f"/api/programs/{program['id']}/versions", {"workspace": {"blocks": {}}, "document": SQUARE}
    ).data


@pytest.fixture
def run(browser: Browser, version: dict[str, Any]) -> Any:
    return browser.post("/api/runs", {"version_id": version["id"], "world": "empty_room"}).data
