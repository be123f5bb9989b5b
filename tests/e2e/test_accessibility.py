"""Every screen through axe: roles, names, contrast, in light, dark and high contrast."""

from pathlib import Path
from typing import Any

import pytest

from tests.e2e.python_pane import edit_python, open_python, write_program
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

AXE = Path(__file__).parents[2] / "ui" / "node_modules" / "axe-core" / "axe.min.js"
# Blockly's own: its toolbox and its blocks have roles whose children axe does not find where it looks
BLOCKLYS = {
    "aria-required-children",
    "aria-valid-attr-value",
    "aria-required-parent",
    "nested-interactive",
    "scrollable-region-focusable",
    "svg-img-alt",
    "aria-allowed-attr",
    "region",
}


def violations(studio: Studio) -> list[str]:
    """What axe finds, less what is Blockly's own business."""
    page = studio.page
    page.wait_for_timeout(300)  # what fades in has another contrast until it is there
    if not page.evaluate("typeof axe === 'object'"):
        page.evaluate(AXE.read_text("utf-8"))
    found: dict[str, Any] = page.evaluate(
        "() => axe.run(document, { resultTypes: ['violations'] })"
    )
    return [
        f"{one['id']}: {node['html'][:160]} {node['failureSummary'][-160:]}"
        for one in found["violations"]
        for node in one["nodes"]
        if not (one["id"] in BLOCKLYS and _is_blocklys(page, node["target"][0]))
    ]


def _is_blocklys(page: Any, selector: str) -> bool:
    inside: bool = page.evaluate(
        "([found, areas]) => !!document.querySelector(found)?.closest(areas)",
        [selector, ".injectionDiv, .blocklyWidgetDiv, .blocklyDropDownDiv, .blocklyComputeCanvas"],
    )
    return inside


@pytest.mark.parametrize("theme", ["light", "dark", "contrast"])
def test_screens_have_names_and_contrast(studio: Studio, theme: str) -> None:
    while studio["theme"].get_attribute("data-theme") != theme:
        studio["theme"].click()
    found: dict[str, list[str]] = {}

    def look(screen: str) -> None:
        found[screen] = violations(studio)

    look("start")
    studio.enter_new_group()
    look("studio, empty")
    write_program(studio, 'robot.move_forward(0.1)\nrobot.say("oi")\n')
    open_python(studio)
    look("studio with text")
    edit_python(studio, "robot.fly()\n")
    look("text with a fault")
    assert {screen: one for screen, one in found.items() if one} == {}
