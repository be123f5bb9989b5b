"""Screens by address: their titles in the browser, and prefetching."""

import re

import pytest
from playwright.sync_api import Request, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def test_each_screen_has_a_title_in_the_language_of_the_page(studio: Studio) -> None:
    expect(studio.page).to_have_title("Grupos · PINEL")
    studio.enter_new_group()
    expect(studio.page).to_have_title("Programa 1 · Programa · PINEL")
    studio["open-work"].click()
    expect(studio.page).to_have_title("Programa 1 · Nossos trabalhos · PINEL")
    studio.choose_language("es")
    expect(studio.page).to_have_title("Programa 1 · Nuestros trabajos · PINEL")
    studio.choose_language("pt-BR")
    studio["home"].click()
    expect(studio.page).to_have_title("Grupos · PINEL")


def test_pointing_at_a_link_fetches_its_screen(studio: Studio) -> None:
    asked: list[str] = []

    def note(request: Request) -> None:
        asked.append(request.url)

    studio.page.on("request", note)
    teacher = studio.page.locator("a[href='#/teacher/lessons']").first
    with studio.page.expect_response(re.compile(r"/assets/TeacherScreen-")):
        teacher.hover()
    expect(studio.page).to_have_title("Grupos · PINEL")
    n_asked = len(asked)
    teacher.click()
    expect(studio.page).to_have_title("Área do professor · PINEL")
    assert not [url for url in asked[n_asked:] if "/assets/" in url]
