"""The app on a temporary data folder, a browser page, and the variants of its appearance."""

import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import cv2
from playwright.sync_api import Browser, Page

from pinel_desktop.messages import LANGUAGES
from tests.gestures.drawn import OPEN, drawn_hand, on_wall

CHROMIUM = shutil.which("chromium-headless-shell") or "/usr/bin/chromium"
ARGUMENTS = [
    "--no-sandbox",
    "--disable-gpu",
    "--enable-unsafe-swiftshader",  # WebGL by the software renderer, for the floor in 3D
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
SIZES = {
    "1366x768": (1366, 768),
    "1024x768": (1024, 768),
    "1024x600": (1024, 600),
    "1920x1080": (1920, 1080),
}
THEMES = ("light", "dark", "contrast")
PIN = "314159"


class ScreenSettings(NamedTuple):
    """Size, theme and language of one round of pictures."""

    size: str
    theme: str
    language: str

    @property
    def name(self) -> str:
        return f"{self.size}-{self.theme}-{self.language}"


QUICK = [ScreenSettings("1366x768", "light", "pt-BR")]
ALL = [
    *(ScreenSettings(size, "light", "pt-BR") for size in SIZES),
    *(ScreenSettings("1366x768", theme, "pt-BR") for theme in THEMES[1:]),
    *(ScreenSettings("1366x768", "light", language) for language in LANGUAGES[1:]),
    ScreenSettings("1024x768", "contrast", "es"),
    ScreenSettings("1920x1080", "dark", "en"),
]


@contextmanager
def application(home: Path) -> Iterator[str]:
    """Runs the app on a data folder, with a drawn hand as its webcam; yields the one-time address of the page."""
    (home / "webcam").mkdir()
    frame = cv2.cvtColor(on_wall(drawn_hand(OPEN, 560), 1280, 720, 360, 80), cv2.COLOR_RGB2BGR)
    cv2.imwrite(str(home / "webcam" / "hand.png"), frame)
    command = [sys.executable, "-m", "pinel_desktop", "serve", "--camera", str(home / "webcam")]
    environment = {**os.environ, "PINEL_HOME": str(home)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as process:
        try:
            yield address_in(process)
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(10)


def address_in(process: "subprocess.Popen[str]") -> str:
    assert process.stdout is not None
    for line in process.stdout:
        if found := re.search(r"http://\S+", line):
            return found[0]
    raise SystemExit("the app printed no address")


class Photographer:
    """Navigates one page through the app and takes screenshots."""

    def __init__(self, browser: Browser, address: str, folder: Path) -> None:
        self.context = browser.new_context(viewport={"width": 1366, "height": 768}, locale="pt-BR")
        self.page: Page = self.context.new_page()
        self.page.on("pageerror", lambda error: print(f"page error: {error}", file=sys.stderr))
        self.page.goto(address)
        self.origin = re.sub(r"(http://[^/]+).*", r"\1", address)
        self.folder = folder
        self.settings = QUICK[0]

    def wear(self, settings: ScreenSettings) -> None:
        self.settings = settings
        width, height = SIZES[settings.size]
        self.page.set_viewport_size({"width": width, "height": height})
        self.call("PUT", "/api/settings/page", {"name": "pinel_theme", "value": settings.theme})
        self.page.reload()
        self.of("language").select_option(settings.language)
        self.page.wait_for_timeout(300)

    def of(self, test_id: str) -> Any:
        return self.page.get_by_test_id(test_id)

    def save(self, name: str) -> None:
        self.page.mouse.move(2, 2)
        self.page.wait_for_timeout(350)
        self.page.screenshot(path=self.folder / f"{name}.png")

    def round(self, name: str) -> None:
        self.save(f"{self.settings.name}-{name}")

    def call(self, method: str, path: str, body: object = None) -> Any:
        return self.page.evaluate(
            """async ([method, path, body]) => {
                const headers = {"Content-Type": "application/json"};
                const init = body ? {method, headers, body: JSON.stringify(body)} : {method};
                return (await fetch(path, init)).json();
            }""",
            [method, path, body],
        )

    def go(self, hash_: str) -> None:
        self.page.goto(f"{self.origin}/{hash_}")

    def open_program(self, program: str) -> None:
        self.go(f"#/program/{program}")
        self.page.locator(".blocklyBlockCanvas .blocklyDraggable").first.wait_for()
        self.page.wait_for_timeout(400)

    def press_run(self) -> None:
        self.page.locator("[data-testid=run][data-does=run]:enabled").click()

    def wait_for_phase(self, *phases: str) -> None:
        selector = ", ".join(f"[data-testid=scene][data-phase={phase}]" for phase in phases)
        self.page.locator(selector).wait_for(timeout=60_000)
