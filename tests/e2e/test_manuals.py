"""The manuals in the page: their list, the search in them and in the help, and an article with its pictures."""

import re

import pytest
from playwright.sync_api import Request, expect

from pinel_desktop.command_name import command_name
from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.studio import Studio
from tests.e2e.test_layout import cut

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

PIN = "2718"


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_who_sets_up_a_pc_reads_how_from_the_first_screen(studio: Studio) -> None:
    studio["manuals-link"].click()
    expect(studio.page).to_have_title("Manuais · PINEL")
    assert violations(studio, "manual-link") == []
    assert cut(studio, "manual-link") == []
    studio["manuals-search"].fill("relatorio problema")
    hit = studio["manual-hit"]
    expect(hit).to_have_count(1)
    expect(hit).to_contain_text("Conferir um computador")
    assert violations(studio, "manual-hit", every_theme=False) == []
    hit.click()
    heading = studio.page.get_by_role("heading", name="Conferir um computador")
    expect(heading).to_be_focused()
    expect(heading).to_be_in_viewport()
    expect(studio.page.get_by_role("article")).to_contain_text(f"{command_name()} doctor")
    assert violations(studio, heading) == []
    studio["manuals-all"].click()
    studio["manuals-back"].click()
    expect(studio["manuals-link"]).to_be_visible()


def test_the_manuals_are_fetched_when_they_are_opened(studio: Studio) -> None:
    fetched: list[str] = []

    def note(request: Request) -> None:
        fetched.append(request.url)

    studio.page.on("request", note)
    studio.enter_new_group(level=None)
    studio["help"].click()
    studio.wait_for_screen("help-search")
    assert [url for url in fetched if "Manual" in url] == []
    studio["help-manuals"].click()
    studio.wait_for_screen("manual-link")
    assert [url for url in fetched if "ManualsScreen" in url]


def test_the_help_finds_them_and_the_way_leads_back_to_the_program(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    program = studio.program_id
    studio["help"].click()
    studio["help-search"].fill("copias de seguranca")
    expect(studio["manual-hit"].first).to_contain_text("Cópias de segurança")
    assert violations(studio, "manual-hit", every_theme=False) == []
    studio["manual-hit"].first.click()
    expect(studio.page.get_by_role("heading", name="Cópias de segurança")).to_be_visible()
    studio["manuals-back"].click()
    studio.wait_until_open()
    assert studio.program_id == program


def test_the_teacher_reads_the_lesson_in_pictures_and_follows_a_link(studio: Studio) -> None:
    studio.enter_new_group(level=None)
    studio["home"].click()
    studio.open_teacher_part(PIN)
    studio["teacher-link"].click()
    studio["teacher-manuals"].click()
    studio.page.locator("[data-testid=manual-link][data-manual=teacher]").click()
    studio["manual-section"].filter(has_text="em imagens").click()
    picture = studio.page.get_by_role("img", name=re.compile("^O plano: oito passos"))
    expect(picture).to_be_in_viewport()
    studio.page.wait_for_function("(one) => one.naturalWidth > 0", arg=picture.element_handle())
    studio.page.get_by_role("article").get_by_role("link", name="plano", exact=True).click()
    expect(studio.page.get_by_role("heading", name="Aula de duas horas")).to_be_visible()
    studio["manuals-back"].click()
    expect(studio["teacher-part"].first).to_be_visible()


def test_a_language_without_manuals_says_so_and_offers_two(studio: Studio) -> None:
    studio["manuals-link"].click()
    studio.choose_language("es")
    line = "Los manuales todavía no existen en este idioma."
    expect(studio.page.get_by_role("status").filter(has_text=line)).to_be_visible()
    expect(studio["manual-link"].first).to_contain_text("Para professoras e professores")
    studio["manuals-language"].click()
    expect(studio["manual-link"].first).to_contain_text("For teachers")
    assert violations(studio, "manual-link", every_theme=False) == []
