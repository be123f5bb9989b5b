"""Operates the world editor by pointer and keyboard; positions are in metres on the floor."""

import re
from typing import Any

from playwright.sync_api import Locator, expect

from tests.e2e.blocks import Place, box_of
from tests.e2e.studio import Studio


class WorldBoard:
    """The world editor of one open page."""

    def __init__(self, studio: Studio) -> None:
        self._studio = studio

    def __getitem__(self, test_id: str) -> Locator:
        return self._studio[f"world-{test_id}"]

    def open(self) -> None:
        self["change"].click()
        expect(self["editor"]).to_be_visible()

    def done(self) -> None:
        self["done"].click()
        expect(self["editor"]).to_have_count(0)

    def choose(self, tool: str) -> None:
        button = self._studio.page.locator(f'[data-testid="world-tool"][data-tool="{tool}"]')
        button.click()
        expect(button).to_have_attribute("aria-pressed", "true")

    def world_object(self, kind: str, index: int = 0) -> Locator:
        at = f'[data-index="{index}"]' if kind != "start" else ""
        return self._studio.page.locator(f'[data-testid="world-thing"][data-kind="{kind}"]{at}')

    def handle(self, name: str) -> Locator:
        return self._studio.page.locator(f'[data-testid="world-handle"][data-handle="{name}"]')

    def number(self, name: str) -> Locator:
        """A field of the panel, such as x."""
        return self["panel"].get_by_test_id(f"world-{name}")

    def at(self, x: float, y: float) -> Place:
        """Screen position of a point of the floor."""
        box = box_of(self["board"])
        camera = (self["board"].get_attribute("data-camera") or "").split()
        middle_x, middle_y, scale = (float(part) for part in camera)
        across = box["x"] + box["width"] / 2 + (x - middle_x) * scale
        return Place(across, box["y"] + box["height"] / 2 - (y - middle_y) * scale)

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        self.pull(self.at(*start), self.at(*end))

    def pull(self, start: Place, end: Place) -> None:
        mouse = self._studio.page.mouse
        mouse.move(start.x, start.y)
        mouse.down()
        mouse.move((start.x + end.x) / 2, (start.y + end.y) / 2, steps=3)
        mouse.move(end.x, end.y, steps=3)
        mouse.up()

    def world(self) -> dict[str, Any]:
        """The group's own world as stored by the server; empty without one."""
        version = self._studio.api(f"/programs/{self._studio.program_id}")["version"]
        return (version and version["world"]) or {}

    def is_own(self) -> bool:
        return bool(self.world())

    def stored(self, key: str, part: str) -> list[Any]:
        """One part of each entry of a list of that world."""
        return [entry[part] for entry in self.world().get(key, [])]

    def inner_walls(self) -> list[Any]:
        return [[wall["from"], wall["to"]] for wall in self.world().get("walls", [])[4:]]

    def eventually(self, read: Any, expected: Any) -> None:
        self._studio.eventually(read, expected)

    def expect_faulty(self, world_object: Locator, is_faulty: bool = True) -> None:
        expect(world_object).to_have_attribute("data-faulty", re.compile(str(is_faulty).lower()))
