"""The app on a temporary data folder, a browser page, and the variants of its appearance."""

import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import cv2
from playwright.sync_api import Browser, Page

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
    "800x1280": (800, 1280),
    "683x768": (683, 768),  # a zoom of 200 %
    "1920x1080": (1920, 1080),
}
THEMES = ("light", "dark", "contrast")
_MAIN_SIZE = "1366x768"
# the pixels of a page that are scrolled out of its window
_HIDDEN_BELOW = """() => Math.max(0, ...[...document.querySelectorAll('.teacher__part, main.screen')]
  .filter((one) => getComputedStyle(one).overflowY !== 'visible')
  .map((one) => one.scrollHeight - one.clientHeight))"""
_MAX_HEIGHT = 2_400
PIN = "314159"


class Variants(NamedTuple):
    """The sizes, themes and languages in which each screen is taken."""

    sizes: Sequence[str]
    themes: Sequence[str]
    languages: Sequence[str]


QUICK = Variants(("1366x768",), ("light",), ("pt-BR",))
ALL = Variants(tuple(SIZES), THEMES, ("pt-BR", "en"))


@contextmanager
def application(home: Path) -> Iterator[str]:
    """Runs the app on a data folder, with a drawn hand as its webcam; yields the one-time address of the page."""
    (home / "webcam").mkdir(exist_ok=True)
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
    """Navigates one page through the app and takes screenshots.

    Args:
        find: returns the faults of the page as it is, for each picture of a round; `is_main` in the main size.
    """

    def __init__(
        self,
        browser: Browser,
        address: str,
        folder: Path,
        variants: Variants = QUICK,
        find: Callable[[Page, bool], list[str]] = lambda _page, _is_main: [],
    ) -> None:
        self.context = browser.new_context(viewport={"width": 1366, "height": 768}, locale="pt-BR")
        self.context.set_default_timeout(20_000)
        self.page: Page = self.context.new_page()
        self.page.on("pageerror", lambda error: self.note(f"page error: {error}"))
        self.page.goto(address)
        self.origin = re.sub(r"(http://[^/]+).*", r"\1", address)
        self.folder = folder
        self.variants, self.find = variants, find
        self.language = "pt-BR"

    def note(self, fault: str) -> None:
        """Writes a fault to the standard output and the list of faults."""
        print(fault, flush=True)
        with (self.folder / "faults.txt").open("a", encoding="utf-8") as faults:
            faults.write(f"{fault}\n")

    def speak(self, language: str) -> None:
        """Chooses a language."""
        self.language = language
        self.of("language").select_option(language)
        self.page.locator(f"html[lang={language}]").wait_for()

    def theme(self, theme: str) -> None:
        """Chooses a theme, without the pointer, which would close open panels."""
        for _ in THEMES:
            if self.page.evaluate("document.documentElement.dataset.theme") == theme:
                return
            self.of("theme").evaluate("(button) => button.click()")

    def resize(self, size: str) -> None:
        width, height = SIZES[size]
        self.page.set_viewport_size({"width": width, "height": height})

    def _unroll(self, size: str) -> None:
        """Makes the window as high as the page, whose lower part a picture would lack."""
        width, height = SIZES[size]
        if below := self.page.evaluate(_HIDDEN_BELOW):
            self.page.set_viewport_size(
                {"width": width, "height": min(height + below, _MAX_HEIGHT)}
            )

    def of(self, test_id: str) -> Any:
        return self.page.get_by_test_id(test_id)

    def save(self, name: str) -> None:
        self.page.mouse.move(2, 2)
        self.page.wait_for_timeout(350)
        self.page.screenshot(path=self.folder / f"{name}.png")

    def round(self, name: str) -> None:
        """Takes the whole page as it is in each size and theme, and looks for faults in each."""
        sizes, themes, _ = self.variants
        for theme in themes:
            self.theme(theme)
            for size in sizes:
                self.resize(size)
                picture = f"{name}-{size}-{theme}-{self.language}"
                self.page.wait_for_timeout(350)
                for fault in self.find(self.page, size == _MAIN_SIZE):
                    self.note(f"{picture}: {fault}")
                self._unroll(size)
                self.save(picture)
        self.resize(_MAIN_SIZE)

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

    def press(self, test_id: str, number: int = 0) -> None:
        self.of(test_id).nth(number).click()

    def open_program(self, program: str) -> None:
        self.go(f"#/program/{program}")
        self.page.locator(".blocklyBlockCanvas .blocklyDraggable").first.wait_for()
        self.page.wait_for_timeout(400)

    def press_run(self) -> None:
        self.page.locator("[data-testid=run][data-does=run]:enabled").click()

    def stop(self) -> None:
        """Stops a run: the next screen may run another program."""
        stop = self.of("stop")
        if stop.is_visible() and stop.is_enabled():
            stop.click()
            self.page.wait_for_timeout(500)

    def end_tour(self) -> None:
        """Leaves the guided first drive, which later screens would show."""
        leave = self.of("tour-skip")
        if leave.is_visible():
            leave.click()

    def wait_for_phase(self, *phases: str) -> None:
        selector = ", ".join(f"[data-testid=scene][data-phase={phase}]" for phase in phases)
        self.page.locator(selector).wait_for(timeout=60_000)
