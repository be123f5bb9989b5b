"""No text or control is cut off on the screen sizes of schools."""

from collections.abc import Iterator, Sequence
from typing import Any

import pytest
from playwright.sync_api import Locator, expect

from pinel_desktop.messages import LANGUAGES
from tests.e2e.app_process import AppProcess
from tests.e2e.layout_faults import COVERED, CUT
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

_SMALL = """() => [...document.querySelectorAll('button, .select, a.button')]
  .filter((e) => !e.closest('.blocklyToast') && e.getBoundingClientRect().width)
  .map((e) => [e.dataset.testid ?? e.className, e.getBoundingClientRect()])
  .filter(([, box]) => box.width < 43.5 || box.height < 43.5)
  .map(([name, box]) => `${name}: ${box.width} x ${box.height}`)"""

SCREENS = [(1366, 768), (1024, 768), (1024, 600), (1920, 1080)]


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def cut(studio: Studio, shows: str | Locator) -> list[Any]:
    """Returns the elements that are cut off on a screen; `shows` as for `wait_for_screen`."""
    studio.wait_for_screen(shows)
    studio.page.evaluate("document.fonts.ready")
    return list(studio.page.evaluate(CUT))


Layout = tuple[str, tuple[int, int]]


def layouts(
    studio: Studio, languages: Sequence[str], sizes: Sequence[tuple[int, int]]
) -> Iterator[Layout]:
    """Yields each combination of language and window size."""
    for language in languages:
        studio.choose_language(language)
        for width, height in sizes:
            studio.page.set_viewport_size({"width": width, "height": height})
            yield language, (width, height)


def test_no_words_are_cut(studio: Studio) -> None:
    expect_uncut(studio, "group-name", "start")
    studio.enter_new_group("Os Engenheiros")
    expect_uncut(studio, "run", "studio", is_large=True)
    studio["ir-toggle"].click()
    expect_uncut(studio, "text-tab", "what the robot gets")
    studio["plots-toggle"].click()
    studio["scene-tools"].click()
    expect_uncut(studio, "plots", "plots and tools", is_large=True)
    studio["scene-tools"].click()
    studio["open-work"].click()
    studio["program-card"].first.wait_for()
    expect_uncut(studio, "program-card", "our work")


def expect_uncut(studio: Studio, shows: str, screen: str, *, is_large: bool = False) -> None:
    """Checks in every language and window size that nothing is cut off; `is_large`: and that buttons are large."""
    for layout in layouts(studio, LANGUAGES, SCREENS):
        assert cut(studio, shows) == [], (screen, layout)
        if is_large:
            assert studio.page.evaluate(_SMALL) == [], (screen, layout)


def test_the_lesson_gives_way_to_the_group_and_its_program(studio: Studio, watch: Watch) -> None:
    watch.expect("net::ERR_FAILED")
    studio.enter_new_group("Os Tatus")
    _begin_lesson(studio, "Quadrados e desvios no pátio da escola")
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["lesson-chip"]).to_be_visible()
    for layout in layouts(studio, ("es", "pt-BR"), SCREENS[:2]):
        assert _cut_names(studio) == [], layout
        _expect_exits(studio, layout)
    studio.page.route("**/api/programs/*/versions", lambda route: route.abort())
    start = studio.blocks.start()
    studio.blocks.drag_from_toolbox("motion", "andar para frente", studio.blocks.below(start))
    expect(studio["saved-mark"]).to_have_attribute("data-state", "failed")
    for layout in layouts(studio, ("pt-BR", "es"), SCREENS[:2]):
        expect(studio["saved-mark"]).to_have_attribute("data-state", "failed")
        assert _cut_names(studio) == [], layout
        assert cut(studio, "editor") == [], layout
        _expect_exits(studio, layout)


def test_long_names_give_way_to_every_button_of_the_header(studio: Studio) -> None:
    studio.enter_new_group("Os Engenheiros da Escola Municipal")
    _begin_lesson(studio, "Quadrados e desvios no pátio da escola")
    name = "Quadrado grande com a caneta vermelha e giros"
    studio.send("PATCH", f"/programs/{studio.program_id}", {"name": name})
    studio.page.reload()
    studio.wait_until_open()
    expect(studio["lesson-chip"]).to_be_visible()
    start = studio.blocks.start()
    studio.blocks.drag_from_toolbox("gestures", "ler sinal", studio.blocks.below(start))
    expect(studio["practice"]).to_be_visible()
    for layout in layouts(studio, ("pt-BR",), SCREENS[:2]):
        _expect_exits(studio, layout)
        assert [one for one in cut(studio, "editor") if "program-name" not in one] == [], layout
    studio.page.set_viewport_size({"width": 1920, "height": 768})
    expect(studio["open-work"]).to_contain_text("Nossos trabalhos")


def test_in_low_windows_a_click_reaches_the_control_that_it_is_meant_for(studio: Studio) -> None:
    studio.enter_new_group("Os Engenheiros")
    covered: dict[tuple[Layout, bool], list[str]] = {}
    for more in (False, True):
        expect(studio["measure-tool"]).to_have_count(2 if more else 0)
        for layout in layouts(studio, LANGUAGES, [(width, 600) for width in range(800, 1400, 50)]):
            studio.wait_for_screen("measure-tool" if more else "editor")
            if found := studio.page.evaluate(COVERED):
                covered[layout, more] = found
        studio["scene-tools"].click()
    assert covered == {}


def _expect_exits(studio: Studio, layout: Layout) -> None:
    for exit_id in ("open-activities", "open-work", "help", "theme", "language"):
        expect(studio[exit_id], f"{exit_id}, {layout}").to_be_in_viewport(ratio=1)


def _begin_lesson(studio: Studio, title: str) -> None:
    """Starts a lesson for the class of the current group."""
    studio.open_teacher_part("314159")
    group = studio.api("/groups")["groups"][0]
    classroom = studio.send("POST", "/classrooms", {"name": f"Turma de {group['name']}"})["id"]
    studio.send("PATCH", f"/groups/{group['id']}", {"classroom_id": classroom})
    studio.send("POST", f"/classrooms/{classroom}/lessons", {"title": title, "activity": "square"})
    studio.send("POST", "/teacher/leave", {})


def _cut_names(studio: Studio) -> list[str]:
    """Returns the names of group and program that are cut off."""
    studio.wait_for_screen("editor")
    names = studio.page.locator(".header__group-name, .program-name__input").all()
    return [
        name.inner_text()
        for name in names
        if name.evaluate("element => element.scrollWidth > element.clientWidth")
    ]


# Elements that are wider than their place or stand in that of the next one.
_OVERFULL = """(places) => [...document.querySelectorAll(places)]
  .filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.textContent || one.className)"""


def test_at_a_zoom_of_200_percent_readings_and_drawings_have_their_room(studio: Studio) -> None:
    studio.enter_new_group()
    studio.page.set_viewport_size({"width": 683, "height": 768})
    studio.wait_for_screen("run")
    assert studio.page.evaluate(_OVERFULL, ".readout dt, .readout dd") == []
    studio.page.goto(f"{studio.origin}/#/practice")
    studio.wait_for_screen("practice-sign")
    drawing = studio.page.locator(".imitation .sign-drawing").bounding_box()
    assert drawing is not None
    assert min(drawing["width"], drawing["height"]) > 150
    studio.page.goto(f"{studio.origin}/#/")
    studio.wait_for_screen("group-name")
    assert studio.page.evaluate(_OVERFULL, ".start, .start__head") == []
