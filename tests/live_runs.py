"""Live runs over HTTP, as the page begins and steers them."""

import time
from typing import Any

from tests.web.browser import ApiResponse, Browser


def saved(browser: Browser, document: Any, world: Any = None) -> str:
    """The id of a version with that document, of a new program in a new group."""
    name = f"Grupo {time.monotonic_ns()}"
    group = browser.post("/api/groups", {"name": name}).data
    program = browser.post(f"/api/groups/{group['id']}/programs", {"name": "Quadrado"}).data
    path = f"/api/programs/{program['id']}/versions"
    content = {"workspace": {"blocks": {}}, "document": document, "world": world}
    version: str = browser.post(path, content).data["id"]
    return version


def start_run(browser: Browser, version_id: str, world: str = "empty_room") -> str:
    answer = browser.post("/api/runs", {"version_id": version_id, "world": world})
    assert answer.status == 200, answer.body
    run: str = answer.data["id"]
    return run


def command(browser: Browser, run: str, do: str, **more: Any) -> ApiResponse:
    return browser.post(f"/api/runs/{run}/commands", {"do": do, **more})
