"""A group's album of stickers: empty, after a solved mission, on paper, and switched off by the teacher."""

import re

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.axe import violations
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import LONG, prepare, to_part
from tests.e2e.test_layout import cut
from tests.e2e.test_missions import put_move, sign_in_with

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(240)]

N_PLACES = 32


def place(studio: Studio, name: str) -> Locator:
    return studio.page.locator(f"[data-testid=album-place][data-sticker={name}]")


def open_album(studio: Studio) -> None:
    studio["open-album"].click()
    studio.wait_for_screen("album-count")


def solve_pushing(studio: Studio) -> None:
    """Fails the open mission first, then passes it."""
    put_move(studio, "1")
    studio.choose_level(2)
    studio["speed"].select_option("10")
    studio.run()
    expect(studio["status-line"]).to_contain_text("Ainda não", timeout=RUN_MS)
    studio.blocks.type_into(studio.blocks.by_text("andar para frente"), "5,6")
    studio.eventually(lambda: studio.values("distance"), [5.6])
    studio.run()
    expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)


def test_a_group_solves_a_mission_and_finds_its_sticker_until_the_teacher_switches_albums_off(
    studio: Studio, open_studio: OpenStudio
) -> None:
    prepare(studio)
    studio["sign-out"].click()
    pupils = open_studio()
    pupils.enter_group("Os Tatus")
    open_album(pupils)
    expect(pupils["album-count"]).to_have_text(f"0 de {N_PLACES} figurinhas")
    expect(place(pupils, "pushing")).to_have_accessible_name(
        re.compile(r"Empurra-caixas.*Lugar vazio.*Empurrem a caixa até o azul\.")
    )
    assert violations(pupils, "album-place") == []
    assert cut(pupils, "album-place") == []

    place(pupils, "pushing").focus()
    place(pupils, "pushing").press("Enter")
    pupils.wait_until_open()
    expect(pupils["mission"]).to_be_visible()
    solve_pushing(pupils)
    news = pupils["new-stickers"]
    expect(news).to_have_text("Figurinhas novas: Empurra-caixas e Consertamos!")
    assert violations(pupils, "mission-done") == []

    news.click()
    expect(pupils["album-count"]).to_have_text(f"2 de {N_PLACES} figurinhas")
    expect(place(pupils, "pushing")).to_have_attribute("data-won", "true")
    expect(place(pupils, "repair")).to_contain_text("Colada em")
    place(pupils, "pushing").click()
    expect(pupils.page).to_have_url(re.compile(r"#/run/"))

    switch_off(studio)
    pupils.page.reload()
    group = pupils.api("/groups")["groups"][0]["id"]
    pupils.page.evaluate(f"location.hash = '#/album/{group}'")
    expect(pupils["album-off"]).to_contain_text("A professora ou o professor desligou o álbum")
    expect(pupils["open-album"]).to_have_count(0)
    pupils["open-work"].click()
    expect(pupils["group-edit"]).to_be_visible()
    expect(pupils["work-album"]).to_have_count(0)


def switch_off(teacher: Studio) -> None:
    sign_in_with(teacher)
    to_part(teacher, "lessons")
    teacher["preset-album"].select_option("Desligado")
    expect(teacher["preset-saved"]).to_have_text("Salvo.")


def test_the_album_is_one_page_of_paper_whatever_the_name_of_the_group(studio: Studio) -> None:
    studio.enter_group(LONG)
    open_album(studio)
    pages = re.findall(rb"/Type\s*/Page\b", studio.page.pdf(prefer_css_page_size=True))
    assert len(pages) == 1


def test_the_album_fits_small_screens(studio: Studio) -> None:
    studio.enter_group("Os Tatus")
    open_album(studio)
    for width, height in ((1024, 600), (683, 384)):
        studio.page.set_viewport_size({"width": width, "height": height})
        assert cut(studio, "album-place") == []
        assert studio.page.evaluate("document.documentElement.scrollWidth") <= width


def test_a_group_without_album_hears_of_no_sticker(studio: Studio, open_studio: OpenStudio) -> None:
    prepare(studio)
    to_part(studio, "lessons")
    studio["preset-album"].select_option("Desligado")
    expect(studio["preset-saved"]).to_have_text("Salvo.")
    studio["sign-out"].click()
    pupils = open_studio()
    pupils.enter_group("Os Tatus")
    expect(pupils["open-album"]).to_have_count(0)
    pupils["open-activities"].click()
    pupils.page.locator("[data-testid=activity-card][data-activity=pushing]").click()
    pupils.wait_until_open()
    solve_pushing(pupils)
    expect(pupils["mission-next"].or_(pupils["mission-others"])).to_be_visible()
    expect(pupils["new-stickers"]).to_have_count(0)
