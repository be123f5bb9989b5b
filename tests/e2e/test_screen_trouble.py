"""Screens whose requests fail, or whose content was deleted."""

import re

import pytest
from playwright.sync_api import Route, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_a_group_that_is_deleted_while_its_program_is_open_is_reported_once_and_can_take_its_text(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("404 (NOT FOUND)")
    answers: list[int] = []
    studio.page.on("response", lambda answer: answers.append(answer.status))
    enter_made_group(studio, [("move_forward", 0.3)])
    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    studio.send("PUT", "/teacher/pin", {"pin": "314159"})
    studio.send("DELETE", f"/groups/{group}")

    studio.page.clock.install()
    studio.blocks.type_into(studio.blocks.by_text("andar para frente"), "0,5")
    expect(studio["deleted"]).to_contain_text("O grupo foi apagado")
    studio["run"].click()
    studio.page.clock.run_for(10_000)  # longer than the interval between two attempts
    # the response to another attempt would come before this one
    studio.page.evaluate("fetch('/api/status')")
    assert answers.count(404) == 1
    expect(studio["problem"]).to_have_count(0)
    expect(studio["unsaved"]).to_have_count(0)
    expect(studio["saved-mark"]).to_have_text("Não foi salvo")
    expect(studio["header-group"]).to_have_count(0)
    expect(studio["program-name"]).to_have_count(0)
    expect(studio["open-work"]).to_be_disabled()

    with studio.page.expect_download() as download:
        studio["take-text"].click()
    assert download.value.suggested_filename == "programa-1.py"
    assert "0.5" in download.value.path().read_text(encoding="utf-8")
    studio["deleted"].get_by_role("link").click()
    expect(studio["group-name"]).to_be_visible()


def test_the_blocks_stay_visible_while_the_server_does_not_answer(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("Failed to load resource")
    enter_made_group(studio, [("move_forward", 0.3)])
    place = studio.page.url
    studio.page.route("**/api/**", lambda route: route.abort())
    studio.blocks.type_into(studio.blocks.by_text("andar para frente"), "0,5")
    for exit_id in ("open-history", "open-work", "home"):
        studio[exit_id].click()
        expect(studio["gone"]).to_be_visible()
        expect(studio.blocks.by_text("andar para frente")).to_contain_text("0,5")
        expect(studio.page).to_have_url(place)
    expect(studio["problem"]).to_have_count(0)

    studio.page.unroute("**/api/**")
    expect(studio["gone"]).to_have_count(0, timeout=15_000)
    studio.wait_until_saved()


def test_a_screen_that_could_not_be_fetched_is_no_dead_end(studio: Studio, watch: Watch) -> None:
    watch.expect("Failed to load resource")
    studio.enter_new_group()
    screen = re.compile(r"WorkScreen.*\.js")
    studio.page.route(screen, lambda route: route.abort())
    studio["open-work"].click()
    expect(studio["problem"]).to_be_visible()
    expect(studio["fetch-again"]).to_be_visible()
    studio.page.unroute(screen)
    studio["fetch-again"].click()
    expect(studio["program-card"]).to_be_visible()


class Failing:
    """Answers requests with an error: at once, or when they are released."""

    def __init__(self) -> None:
        self.held: list[Route] | None = None

    def answer(self, route: Route) -> None:
        if self.held is None:
            route.fulfill(status=500, body="{}")
        else:
            self.held.append(route)

    def hold(self) -> None:
        self.held = []

    def release(self) -> None:
        held, self.held = self.held or [], None
        for route in held:
            self.answer(route)


@pytest.mark.parametrize(
    ("place", "question", "sign"),
    [
        ("", "**/api/status", "group-card"),
        ("", "**/api/groups", "group-card"),
        ("work/{group}", "**/api/groups/*/runs**", "program-card"),
        ("program/{program}", "**/api/programs/*", "run"),
    ],
)
def test_a_screen_whose_first_question_is_answered_with_an_error_says_so_and_can_be_tried_again(
    studio: Studio, watch: Watch, place: str, question: str, sign: str
) -> None:
    watch.expect("500 (Internal Server Error)")
    group = studio.send("POST", "/groups", {"name": studio.unique("Os Tatus")})["id"]
    program = studio.send("POST", f"/groups/{group}/programs", {"name": "Programa 1"})["id"]
    where = place.format(group=group, program=program)
    failing = Failing()
    studio.page.route(question, failing.answer)
    studio.page.goto(f"{studio.origin}/#/{where}")
    studio.page.reload()
    expect(studio["not-loaded"]).to_be_visible()
    expect(studio["problem"]).to_be_visible()
    expect(studio.page.get_by_role("heading", level=1)).to_have_count(1)
    expect(studio.page.get_by_role("main")).not_to_have_attribute("aria-busy", "true")

    # other parts of the page may send the same request; the button is busy while the screen's own
    # is pending
    failing.hold()
    studio["try-again"].click()
    expect(studio["try-again"]).to_have_attribute("aria-busy", "true")
    failing.release()  # requests still fail
    expect(studio["try-again"]).not_to_have_attribute("aria-busy", "true")
    studio.page.unroute(question)
    studio["try-again"].click()
    expect(studio[sign].first).to_be_visible()
    expect(studio["not-loaded"]).to_have_count(0)


def test_what_is_not_there_leaves_no_other_program_in_the_header(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("404 (NOT FOUND)")
    studio.enter_new_group()
    program = studio.page.url
    for place in ("program", "versions", "run", "work"):
        studio.page.goto(program)
        studio.wait_until_open()
        studio.page.goto(f"{studio.origin}/#/{place}/nothing")
        expect(studio["problem"], place).to_be_visible()
        for part in ("header-group", "program-name", "saved-mark"):
            expect(studio[part], f"{part}, {place}").to_have_count(0)
        studio.page.get_by_role("link", name="Voltar ao início").click()
        expect(studio["group-card"].first).to_be_visible()
        expect(studio["problem"]).to_have_count(0)
