"""Takes screenshots of every screen of the real app, in several sizes, themes and languages.

    python -m scripts.screenshots FOLDER            every screen, for inspection
    python -m scripts.screenshots FOLDER --quick    Portuguese, light, 1366 x 768 only
    python -m scripts.screenshots FOLDER --theme dark --language en --size 683x768 --screens teacher-
    python -m scripts.screenshots docs/images --readme   the pictures of README and manual

The app runs on temporary data folders with generated groups, programs and runs. Pictures are named
SCREEN-SIZE-THEME-LANGUAGE.png; sheets show the screens of a variant side by side; with `--check` faults.txt lists cut
texts, covered controls and what axe finds.
"""

import argparse
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from scripts.screenshots import lesson, pupils
from scripts.screenshots.camera import (
    ALL,
    ARGUMENTS,
    CHROMIUM,
    QUICK,
    SIZES,
    THEMES,
    Photographer,
    Variants,
    application,
)
from scripts.screenshots.faults import faults
from scripts.screenshots.screens import PUPILS, School, photograph
from scripts.screenshots.sheets import contact_sheets
from scripts.screenshots.teachers import SIGNED_IN, TEACHERS


def readme(browser: Browser, folder: Path) -> None:
    """Takes the pictures of README and manual."""
    with tempfile.TemporaryDirectory() as home, application(Path(home)) as address:
        camera = Photographer(browser, address, folder)
        camera.of("group-name").wait_for()
        pupils.readme(camera, pupils.seed(camera))
    with tempfile.TemporaryDirectory() as home:
        past = lesson.play(Path(home))
        with application(Path(home)) as address:
            camera = Photographer(browser, address, folder)
            camera.of("group-card").first.wait_for()
            lesson.readme(camera, past)


@contextmanager
def school(browser: Browser, folder: Path, variants: Variants, *, checks: bool) -> Iterator[School]:
    """Opens the app on a finished lesson, and on a class at work."""
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as stick:
        past = lesson.play(Path(home))
        with application(Path(home)) as address:
            options = (faults,) if checks else ()
            camera = Photographer(browser, address, folder, variants, *options)
            camera.of("group-card").first.wait_for()
            seeded = pupils.seed(camera)
            lesson.share(camera, Path(stick))
            lesson.calibrate(camera, past)
            camera.page.reload()
            yield School(camera, seeded, past)


def inspect(found: School, wanted: tuple[str, ...]) -> None:
    """Takes every screen in every variant, for inspection."""
    camera = found.camera
    for language in camera.variants.languages:
        camera.go("#/")
        camera.speak(language)
        photograph(found, PUPILS | TEACHERS, wanted)
        lesson.enter(camera)
        photograph(found, SIGNED_IN, wanted)
        camera.call("POST", "/api/teacher/leave")
        camera.page.reload()


def sheets(folder: Path, variants: Variants) -> None:
    for size, theme, language in product(*variants):
        for sheet in contact_sheets(
            folder, f"{size}-{theme}-{language}", 4 if "800" in size else 3
        ):
            print(sheet)


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--quick", action="store_true", help="one size, theme and language")
    parser.add_argument("--readme", action="store_true", help="the pictures of README and manual")
    parser.add_argument("--size", action="append", choices=SIZES, help="only this size")
    parser.add_argument("--theme", action="append", choices=THEMES, help="only this theme")
    parser.add_argument("--language", action="append", help="only this language")
    parser.add_argument("--screens", action="append", help="only screens whose name begins so")
    parser.add_argument("--check", action="store_true", help="look for faults in each picture")
    return parser.parse_args()


def main() -> None:
    chosen = arguments()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    given = QUICK if chosen.quick else ALL
    variants = Variants(
        chosen.size or given.sizes,
        chosen.theme or given.themes,
        chosen.language or given.languages,
    )
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        if chosen.readme:
            readme(browser, chosen.folder)
        else:
            with school(browser, chosen.folder, variants, checks=chosen.check) as found:
                inspect(found, tuple(chosen.screens or [""]))
            sheets(chosen.folder, variants)
        browser.close()


if __name__ == "__main__":
    main()
