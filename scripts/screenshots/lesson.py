"""Screenshots of the teacher's part: the review of a finished lesson, export and import of work."""

from pathlib import Path
from typing import NamedTuple

from scripts.screenshots.camera import PIN, Photographer
from tests.e2e.past_lesson import SQUARE, PastLesson, Step, past_lesson

TRIED: list[Step] = [("move_forward", 1), ("turn", 80)] * 4
FAR: list[Step] = [("move_forward", 9)]


class Past(NamedTuple):
    """The generated lesson."""

    lesson: str
    program: str
    versions: tuple[str, str]
    runs: tuple[str, str]


def play(home: Path) -> Past:
    """Writes a lesson of five groups to a new database."""
    with past_lesson(home) as lesson:
        first = _group(lesson, "Capivaras", 2, [FAR, TRIED, SQUARE])
        _group(lesson, "Tatus", 4, [TRIED, SQUARE])
        _group(lesson, "Emas", 3, [SQUARE])
        _group(lesson, "Antas", 6, [FAR, FAR, TRIED])
        lesson.group("Dourados").edit(*SQUARE[:2])
        versions, runs = first
        program = lesson.store.versions.get(versions[0]).program_id
        return Past(lesson.lesson, program, (versions[0], versions[-1]), (runs[0], runs[-1]))


def _group(
    lesson: PastLesson, name: str, minute: float, tries: list[list[Step]]
) -> tuple[list[str], list[str]]:
    """Writes a group's attempts: each is an edit and, minutes later, a run; only the square passes the activity."""
    group = lesson.group(name)
    versions, runs = [], []
    for place, steps in enumerate(tries):
        lesson.at(minute + 5 * place)
        versions.append(group.edit(*steps))
        lesson.at(minute + 5 * place + 2)
        runs.append(group.run())
        group.judged(runs[-1], passed=steps is SQUARE)
    return versions, runs


def photograph(camera: Photographer, past: Past, stick: Path) -> None:
    """Takes every screen of the review in the current settings."""
    _enter(camera)
    camera.go(f"#/lesson/{past.lesson}")
    camera.of("review-group").first.wait_for()
    camera.round("lesson")
    camera.of("review-open").first.click()
    camera.of("review-run").first.wait_for()
    camera.round("lesson-group")
    camera.go("#/runs")
    camera.of("compare-choose").first.wait_for()
    camera.round("runs")
    camera.go(f"#/compare/{'/'.join(past.runs)}")
    camera.of("compare-side").nth(1).wait_for()
    camera.round("two-runs")
    camera.go(f"#/run/{past.runs[0]}")
    camera.of("note-open").click()
    camera.round("note")
    camera.go(f"#/versions/{past.program}")
    camera.of("version-shown").wait_for()
    camera.round("history")
    camera.go(f"#/differences/{past.program}/{'/'.join(past.versions)}")
    camera.of("difference").first.wait_for()
    camera.round("differences")
    files(camera, stick)


def files(camera: Photographer, stick: Path) -> None:
    """Exports the work of this PC to a folder and imports it again."""
    camera.call("PUT", "/api/folders/shared", {"path": str(stick)})
    if not any(stick.iterdir()):
        camera.call("POST", "/api/bundles", {"folder": str(stick)})
        (stick / "estragado.pinel").write_bytes(b"SQLite format 3")
    camera.go("#/teacher/files")
    camera.of("merge-files").wait_for()
    camera.round("files")
    camera.of("merge-files").click()
    camera.of("merge-results").wait_for()
    camera.of("merge-results").scroll_into_view_if_needed()
    camera.round("files-merged")


def readme(camera: Photographer, past: Past) -> None:
    """Takes the pictures of README and manual: the lesson, and a run of it on the projector."""
    _enter(camera)
    camera.go(f"#/lesson/{past.lesson}")
    camera.of("review-group").first.wait_for()
    camera.save("lesson")
    camera.go(f"#/present/same/{past.runs[0]}")
    camera.of("presentation").wait_for()
    camera.page.keyboard.press("PageDown")
    camera.page.wait_for_timeout(1_500)
    camera.save("projector")


def _enter(camera: Photographer) -> None:
    """Sets the PIN, or enters it."""
    if camera.call("GET", "/api/teacher")["has_pin"]:
        camera.call("POST", "/api/teacher/enter", {"pin": PIN})
    else:
        camera.call("PUT", "/api/teacher/pin", {"pin": PIN})
    camera.page.reload()
