"""Fixtures with the real app and a real browser; both are checked for unexpected requests and errors."""

import itertools
import os
import shutil
from collections.abc import Callable, Generator, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, expect, sync_playwright

from pinel_desktop.settings import LANGUAGE, SETTINGS
from pinel_desktop.web.page import STATIC
from tests.e2e.app_process import AppProcess
from tests.e2e.delays import slower
from tests.e2e.past_lesson import school_after
from tests.e2e.review_school import Past, Teacher, play, sign_in
from tests.e2e.studio import TIMEOUT_MS, Studio
from tests.e2e.watch import Watch

# Debian's headless shell, a third faster than the whole browser
CHROMIUM = (
    os.environ.get("PINEL_CHROMIUM")
    or shutil.which("chromium-headless-shell")
    or "/usr/bin/chromium"
)
SCREEN = {"width": 1366, "height": 768}
PAGE_SETTINGS = [name for name, one in SETTINGS.items() if one.of_page and name != LANGUAGE]
ARTIFACTS = Path(__file__).parents[1] / "artifacts"

OpenStudio = Callable[..., Studio]


@pytest.hookimpl(trylast=True)  # after the markers of the tests are known
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Gives tests longer time limits if responses are delayed (`--delay-requests`)."""
    for item in items if slower() > 1 else ():
        own = item.get_closest_marker("timeout")
        usual_s = float(own.args[0] if own else config.getini("timeout"))
        item.add_marker(pytest.mark.timeout(usual_s * slower()), append=False)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        # Chromium's sandbox does not work as root, as in build containers
        sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []
        # a tenth faster than the software GPU
        arguments = ["--disable-gpu", *sandbox]
        expect.set_options(timeout=TIMEOUT_MS)
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        yield browser
        browser.close()


@pytest.fixture
def app(tmp_path: Path) -> Iterator[AppProcess]:
    """The app, started on an empty folder."""
    yield from _started(tmp_path)


@pytest.fixture(scope="module")
def lasting_app(tmp_path_factory: pytest.TempPathFactory) -> Iterator[AppProcess]:
    """One app per test file, for tests that need no empty folder; each test uses its own group."""
    yield from _started(tmp_path_factory.mktemp("home"))


def _started(home: Path) -> Iterator[AppProcess]:
    assert (STATIC / "index.html").is_file(), "the page is not built: make setup"
    app = AppProcess(home)
    app.start()
    yield app
    app.stop()


@pytest.fixture
def watch() -> Iterator[Watch]:
    watch = Watch()
    yield watch
    watch.verdict()


@pytest.fixture
def open_studio(
    browser: Browser, app: AppProcess, watch: Watch, request: pytest.FixtureRequest
) -> Iterator[OpenStudio]:
    """Opens a browser context at the given address, or with the cookie of an earlier context."""
    contexts: list[BrowserContext] = []

    def open_(link: str = "", **options: Any) -> Studio:
        cookies = None if link else app.signed_in
        settings = {"viewport": SCREEN, "locale": "pt-BR", "reduced_motion": "reduce", **options}
        context = browser.new_context(storage_state=cookies, **settings)
        context.set_default_timeout(TIMEOUT_MS)
        contexts.append(context)
        watch.over(context)
        studio = Studio(context.new_page())
        studio.page.goto(link or (app.origin if cookies else app.link))
        app.signed_in = app.signed_in or context.storage_state()
        return studio

    yield open_
    # the next test uses the same app
    if contexts and {"lasting_app", "school"} & set(request.fixturenames):
        for page in itertools.chain.from_iterable(context.pages for context in contexts):
            watch.settle(page)
        # a restart of the app signs out all contexts but the newest
        settings, newest = f"{app.origin}api/settings", contexts[-1]
        assert newest.request.put(settings, data={"language": "pt-BR"}).ok
        for name in PAGE_SETTINGS:
            assert newest.request.put(f"{settings}/page", data={"name": name, "value": ""}).ok
    for number, context in enumerate(contexts):
        _save_screenshot(context, f"{request.node.name}-{number}", request)
        context.close()


@pytest.fixture
def studio(open_studio: OpenStudio) -> Studio:
    """The page of an empty app."""
    return open_studio()


@pytest.fixture
def open_pc(
    browser: Browser, watch: Watch, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[OpenStudio]:
    """Opens the page of another PC: an app with an empty database, started with the given options."""
    with ExitStack() as stack:

        def open_(*options: str) -> Studio:
            app = AppProcess(tmp_path_factory.mktemp("pc"), *options)
            link = app.start()
            stack.callback(app.stop)
            context = browser.new_context(
                viewport={"width": 1366, "height": 768}, locale="pt-BR", reduced_motion="reduce"
            )
            stack.callback(context.close)
            context.set_default_timeout(TIMEOUT_MS)
            watch.over(context)
            studio = Studio(context.new_page())
            studio.page.goto(link)
            return studio

        yield open_


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[AppProcess, Past]]:
    """The app on a database with a finished lesson."""
    with school_after(tmp_path_factory.mktemp("school"), play) as school:
        yield school


@pytest.fixture
def teacher(open_studio: OpenStudio, school: tuple[AppProcess, Past]) -> Teacher:
    studio = open_studio()
    sign_in(studio)
    return Teacher(studio, school[1])


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item,
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if report.when == "call" and report.failed:
        item.stash[_FAILED] = True
    return report


_FAILED = pytest.StashKey[bool]()


def _save_screenshot(context: BrowserContext, name: str, request: pytest.FixtureRequest) -> None:
    """Saves a screenshot of a failed test."""
    if not request.node.stash.get(_FAILED, False):
        return
    ARTIFACTS.mkdir(exist_ok=True)
    for page in context.pages:
        page.screenshot(path=ARTIFACTS / f"{name}.png")
