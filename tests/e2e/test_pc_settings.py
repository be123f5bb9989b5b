"""Settings stored on a PC survive window and app: a browser without cookies shows them again."""

import pytest
from playwright.sync_api import Route, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.python_pane import write_program
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


def test_theme_level_class_and_mute_are_there_after_the_window_was_closed(
    open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    studio = open_studio()
    studio.send("PUT", "/teacher/pin", {"pin": "2468"})
    for name in ("5º A", "5º B"):
        studio.send("POST", "/classrooms", {"name": name})
    studio.page.reload()
    studio["class-chip"].filter(has_text="5º B").click()
    studio["theme"].click()
    studio.enter_new_group(level=2)
    write_program(studio, "robot.beep()\n")
    studio["mute"].click()
    expect(studio["mute"]).to_have_attribute("data-muted", "true")
    group = studio.api("/groups")["groups"][0]
    watch.settle(studio.page)
    studio.page.context.close()

    app.stop()
    app.start()
    reopened = open_studio()
    expect(reopened.page.locator("html")).to_have_attribute("data-theme", "dark")
    chosen = reopened["class-chip"].filter(has_text="5º B")
    expect(chosen).to_have_attribute("aria-pressed", "true")
    reopened.page.get_by_text(group["name"]).first.click()
    reopened.wait_until_open()
    expect(reopened["level"]).to_have_value("2")
    expect(reopened["mute"]).to_have_attribute("data-muted", "true")


def test_the_page_arrives_in_its_theme(open_studio: OpenStudio) -> None:
    studio = open_studio()
    studio["theme"].click()
    expect(studio.page.locator("html")).to_have_attribute("data-theme", "dark")
    # a setting without the server's response is sent again by the next page
    studio.page.wait_for_function("() => sessionStorage.length === 0")
    assert 'data-theme="dark"' in studio.page.context.request.get(studio.origin).text()
    asked: list[str] = []
    studio.page.on("request", lambda request: asked.append(request.url))
    studio.page.reload()
    expect(studio.page.locator("html[data-ready]")).to_be_attached()
    assert not [url for url in asked if "/settings" in url]


def test_a_language_that_is_chosen_before_the_server_has_answered_stays(studio: Studio) -> None:
    expect(studio.page.locator("html[data-ready]")).to_be_attached()
    status = studio.api("/status")
    assert status["language"] == "pt-BR"
    held: list[Route] = []

    def hold_the_first(route: Route) -> None:
        if held:
            route.continue_()
        held.append(route)

    studio.page.route("**/api/status", hold_the_first)
    studio.page.reload()
    studio.choose_language("en")
    held[0].fulfill(json=status)
    expect(studio.page.locator("html[data-ready]")).to_be_attached()
    expect(studio["language"]).to_have_value("en")


def test_a_language_that_is_chosen_in_the_moment_of_a_reload_stays(studio: Studio) -> None:
    expect(studio.page.locator("html[data-ready]")).to_be_attached()
    studio.page.route("**/api/settings", lambda route: None, times=1)  # the reload ends the request
    studio.choose_language("en")
    studio.page.reload()
    expect(studio.page.locator("html")).to_have_attribute("lang", "en")
    studio.eventually(lambda: studio.api("/status")["language"], "en")
