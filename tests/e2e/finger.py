"""Touches the screen with a finger; Playwright itself only taps."""

from playwright.sync_api import Locator, Page

from tests.e2e.blocks import GRIP_PX, Place, box_of

_STEPS = 8


class Finger:
    """Sends touch events as the browser gets them from a touch screen."""

    def __init__(self, page: Page) -> None:
        self._screen = page.context.new_cdp_session(page)

    def drag(self, outline: Locator, to: Place) -> None:
        """Touches a block at its icon and drags its upper left corner to the place."""
        box = box_of(outline)
        x, y = box["x"] + GRIP_PX[0], box["y"] + GRIP_PX[1]
        end_x, end_y = to.x + GRIP_PX[0], to.y + GRIP_PX[1]
        self._touch("touchStart", x, y)
        for step in range(1, _STEPS + 1):
            part = step / _STEPS
            self._touch("touchMove", x + (end_x - x) * part, y + (end_y - y) * part)
        for shake in (2, -2, 1):
            self._touch("touchMove", end_x + shake, end_y + shake)
        self._screen.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    def stroke(self, start: Place, end: Place) -> None:
        """Draws from one point to another."""
        self._touch("touchStart", start.x, start.y)
        for step in range(1, _STEPS + 1):
            part = step / _STEPS
            across, down = (end.x - start.x) * part, (end.y - start.y) * part
            self._touch("touchMove", start.x + across, start.y + down)
        self._screen.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    def spread(self, middle: Place, start_px: float, end_px: float) -> None:
        """Moves two fingers apart, or together; the distances are those of each to the middle."""
        for step in range(_STEPS + 1):
            off = start_px + (end_px - start_px) * step / _STEPS
            places = [Place(middle.x - off, middle.y), Place(middle.x + off, middle.y)]
            self._touch_at("touchMove" if step else "touchStart", places)
        self._touch_at("touchEnd", [])

    def _touch(self, kind: str, x: float, y: float) -> None:
        self._touch_at(kind, [Place(x, y)])

    def _touch_at(self, kind: str, places: list[Place]) -> None:
        points = [{"x": one.x, "y": one.y, "id": index} for index, one in enumerate(places)]
        self._screen.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
