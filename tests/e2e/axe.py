"""Checks a screen for accessibility with axe: roles, names, and contrast in all themes."""

from pathlib import Path
from typing import Any

from playwright.sync_api import Locator, Page

from tests.e2e.studio import Studio

AXE = Path(__file__).parents[2] / "ui" / "node_modules" / "axe-core" / "axe.min.js"
THEMES = {"light", "dark", "contrast"}
_CONTRAST = "runOnly: ['color-contrast']"


def violations(studio: Studio, shows: str | Locator, *, every_theme: bool = True) -> list[str]:
    """Returns axe's violations, those in Blockly's elements too; restores the theme.

    Args:
        shows: an element that only this screen shows, as for `wait_for_screen`.
        every_theme: False for a screen that another test checks in every theme: colours do not depend on language or
            size.
    """
    page = studio.page
    studio.wait_for_screen(shows)
    first = _theme(page)
    found = violations_now(page)
    if not every_theme:
        return found
    visited = {first}
    while _next_theme(page) != first:
        visited.add(_theme(page))
        # fading elements have another contrast until their animation ends
        studio.wait_for_screen(shows)
        # the only rule that depends on the theme
        found += violations_now(page, _CONTRAST)
    assert visited == THEMES
    return found


def violations_now(page: Page, options: str = "") -> list[str]:
    """Returns axe's violations of a page as it is; `options` are further options of `axe.run`."""
    if not page.evaluate("typeof axe === 'object'"):
        page.evaluate(AXE.read_text("utf-8"))
    answer: dict[str, Any] = page.evaluate(
        f"() => axe.run(document, {{ resultTypes: ['violations'], {options} }})"
    )
    return [
        f"{_theme(page)}, {one['id']}: {node['html'][:160]} {node['failureSummary'][-160:]}"
        for one in answer["violations"]
        for node in one["nodes"]
    ]


def _theme(page: Page) -> str:
    theme: str = page.evaluate("document.documentElement.dataset.theme")
    return theme


def _next_theme(page: Page) -> str:
    """Switches the theme without the pointer, which would close open panels."""
    page.get_by_test_id("theme").evaluate("(button) => button.click()")
    return _theme(page)
