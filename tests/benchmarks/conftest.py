"""Fixtures of the benchmarks that draw in a browser; each benchmark has its own `browser`."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from tests.e2e.app_process import AppProcess


@pytest.fixture
def page(browser: Browser, tmp_path: Path) -> Iterator[Page]:
    """The page of an app on an empty folder, in Portuguese."""
    app = AppProcess(tmp_path)
    app.start()
    try:
        context = browser.new_context(viewport={"width": 1366, "height": 768}, locale="pt-BR")
        page = context.new_page()
        page.goto(app.link)
        yield page
    finally:
        app.stop()
