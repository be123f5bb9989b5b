"""Takes screenshots of every screen of the real app, in several sizes, themes and languages.

    python -m scripts.screenshots FOLDER            every screen, for inspection
    python -m scripts.screenshots FOLDER --quick    Portuguese, light, 1366 x 768 only
    python -m scripts.screenshots docs/images --readme   the pictures of README and manual

The app runs on temporary data folders with generated groups, programs and runs.
"""

import argparse
import tempfile
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright

from scripts.screenshots import lesson, pupils
from scripts.screenshots.camera import (
    ALL,
    ARGUMENTS,
    CHROMIUM,
    QUICK,
    Photographer,
    ScreenSettings,
    application,
)


def pupils_screens(browser: Browser, folder: Path, settings: list[ScreenSettings]) -> None:
    """Takes the pupils' screens: an empty app, and a class at work.

    Without settings, takes the pictures of the README.
    """
    with tempfile.TemporaryDirectory() as home, application(Path(home)) as address:
        camera = Photographer(browser, address, folder)
        camera.of("group-name").wait_for()
        if settings:
            camera.round("first-start")
        seeded = pupils.seed(camera)
        if not settings:
            pupils.readme(camera, seeded)
        for setting in settings:
            camera.wear(setting)
            pupils.photograph(camera, seeded)


def lesson_screens(browser: Browser, folder: Path, settings: list[ScreenSettings]) -> None:
    """Takes the screens of the lesson review; without settings, the picture of the README."""
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as stick:
        past = lesson.play(Path(home))
        with application(Path(home)) as address:
            camera = Photographer(browser, address, folder)
            camera.of("group-card").first.wait_for()
            if not settings:
                lesson.readme(camera, past)
            for setting in settings:
                camera.wear(setting)
                lesson.photograph(camera, past, Path(stick))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--quick", action="store_true", help="one size, theme and language")
    parser.add_argument(
        "--readme", action="store_true", help="the pictures of README and manual only"
    )
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    settings = [] if arguments.readme else QUICK if arguments.quick else ALL
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        pupils_screens(browser, arguments.folder, settings)
        lesson_screens(browser, arguments.folder, settings)
        browser.close()


if __name__ == "__main__":
    main()
