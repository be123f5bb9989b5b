"""Operates the workspace by pointer and keyboard: drags blocks, types into fields."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

from playwright.sync_api import Locator, Page, expect

_WORKSPACE = ".blocklySvg .blocklyBlockCanvas"
_NOTCH_PX = 8  # notch below a block, not part of its stacking height
_STATEMENT_INPUT_PX = 16  # indentation of the body of a loop
GRIP_PX = (20, 26)  # where a block is grabbed: on its icon


@dataclass(frozen=True)
class Place:
    """Target of the upper left corner of a block, in screen pixels."""

    x: float
    y: float


Box = dict[str, float]
T = TypeVar("T")

# read at the start of the drag, because requests of the page may move the blocks before
Target = Callable[[], Place]
_A_FRAME = "new Promise(requestAnimationFrame)"


def begin_mission(page: Page) -> None:
    """Closes the mission's sheet by its button, and skips the tour that this begins for a new group."""
    start = page.get_by_test_id("mission-start")
    begins_tour = start.get_attribute("data-tour") == "true"
    start.click()
    if begins_tour:
        page.get_by_test_id("tour-skip").click()


class Blocks:
    """Finds blocks by their text, or by its start."""

    def __init__(self, page: Page) -> None:
        self._page = page

    def category(self, name: str) -> Locator:
        return self._page.get_by_test_id(f"toolbox-{name}")

    def all(self) -> Locator:
        """Every block, without shadow blocks."""
        excluded = ":not(.blocklyInsertionMarker):not(.blocklyShadow)"
        return self._page.locator(f"{_WORKSPACE} .blocklyDraggable{excluded}")

    def by_id(self, block: str) -> Locator:
        return self._page.locator(f'{_WORKSPACE} [data-id="{block}"]')

    def by_text(self, text: str) -> Locator:
        """The innermost block with the text."""
        return self.all().filter(has_text=text).last

    def start(self) -> Locator:
        return self.all().first

    def running(self) -> Locator:
        return self._page.locator(f"{_WORKSPACE} .pinelRunning")

    def faulty(self) -> Locator:
        return self._page.locator(f"{_WORKSPACE} .pinelFault")

    def loose(self) -> Locator:
        return self._page.locator(f"{_WORKSPACE} .pinelLoose:not(.blocklyShadow)")

    def fault_text(self) -> Locator:
        return self._page.locator(".blocklyTextBubble")

    def in_flyout(self, text: str | re.Pattern[str]) -> Locator:
        """A block of the open category."""
        return self._page.locator(
            ".blocklyFlyout .blocklyBlockCanvas > .blocklyDraggable", has_text=text
        ).first

    def drag_from_toolbox(self, category: str, text: str, to: Target) -> None:
        """Drags a block out of its category."""
        before = self.all().count()
        self.open_category(category)
        outline = self.in_flyout(text).locator("> .blocklyPath")
        parts = self._parts(text)
        self._drag(outline, to)
        expect(self.all()).to_have_count(before + parts)

    def click_in_toolbox(self, category: str, text: str | re.Pattern[str]) -> None:
        """Opens a category and clicks a block of it."""
        self.open_category(category)
        self.click_in_flyout(text)

    def open_category(self, name: str) -> None:
        """Clicks a category, unless its flyout is open: a second click would close it.

        Closes the mission's sheet first, which may cover the flyout.
        """
        if self._page.get_by_test_id("mission-start").is_visible():
            begin_mission(self._page)
        category = self.category(name)
        if category.get_attribute("aria-selected") != "true":
            category.click()

    def click_in_flyout(self, text: str | re.Pattern[str]) -> None:
        """Clicks near the upper left corner of a block, where a loop has no statement input."""
        expected = self.all().count() + self._parts(text)
        self.in_flyout(text).click(position={"x": 12, "y": 18})
        expect(self.all()).to_have_count(expected)

    def drag(self, block: Locator, to: Target) -> None:
        """Moves a block of the workspace, with the blocks below it."""
        self._drag(block.locator("> .blocklyPath").first, to)

    def select(self, block: Locator) -> None:
        """Clicks a block where it has neither icon nor field."""
        box = box_of(block.locator("> .blocklyPath").first)
        self._page.mouse.click(box["x"] + 5, box["y"] + box["height"] - 16)

    def below(self, block: Locator) -> Target:
        return lambda: _place(block, lambda box: (0, box["height"] - _NOTCH_PX))

    def inside(self, loop: Locator, row_px: float = 50) -> Target:
        return lambda: _place(loop, lambda box: (_STATEMENT_INPUT_PX, row_px))

    def beside(self, block: Locator, gap_px: float = 160) -> Target:
        return lambda: _place(block, lambda box: (box["width"] + gap_px, 40))

    def type_into(self, block: Locator, value: str, number: int = 0) -> None:
        """Clicks a field of the block and overwrites its value."""
        block.locator(".blocklyInputField").nth(number).click()
        editor = self._page.locator(".blocklyHtmlInput")
        editor.fill(value)
        editor.press("Enter")
        expect(editor).to_have_count(0)

    def choose(self, block: Locator, text: str) -> None:
        """Picks an entry of the block's dropdown."""
        block.locator("> .blocklyDropdownField").first.click()
        self._page.locator(".blocklyDropDownDiv .blocklyMenuItem", has_text=text).click()

    def _drag(self, outline: Locator, to: Target) -> None:
        mouse = self._page.mouse
        box, place = self._at_rest(lambda: (box_of(outline), to()))
        mouse.move(box["x"] + GRIP_PX[0], box["y"] + GRIP_PX[1])
        mouse.down()
        end = (place.x + GRIP_PX[0], place.y + GRIP_PX[1])
        mouse.move(*end, steps=6)
        # a hand arrives with small movements; the first of them closes the gap that the drag opened
        # last
        for step in (3, -3, 1, -1):
            mouse.move(end[0] + step, end[1] + step)
        mouse.up()

    def _at_rest(self, read: Callable[[], T]) -> T:
        """Reads repeatedly until two values, a frame apart, are equal."""
        last, now = None, read()
        while now != last:
            self._page.evaluate(_A_FRAME)
            last, now = now, read()
        return now

    def _parts(self, text: str | re.Pattern[str]) -> int:
        """Number of blocks in a block of the open category, including nested blocks."""
        inner = ".blocklyDraggable:not(.blocklyShadow)"
        return 1 + self.in_flyout(text).locator(inner).count()


def _place(block: Locator, offset: Callable[[Box], tuple[float, float]]) -> Place:
    box = box_of(block.locator("> .blocklyPath").first)
    right, down = offset(box)
    return Place(box["x"] + right, box["y"] + down)


def box_of(locator: Locator) -> Box:
    locator.scroll_into_view_if_needed()
    box = locator.bounding_box()
    assert box is not None, f"{locator} is not to be seen"
    return {"x": box["x"], "y": box["y"], "width": box["width"], "height": box["height"]}
