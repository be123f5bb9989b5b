"""A finished lesson, runs on a real robot, and the teacher's pictures of README and manual."""

from pathlib import Path
from typing import NamedTuple

from scripts.screenshots.camera import PIN, Photographer
from tests.calibration.recorded_runs import measured_pattern
from tests.e2e.past_lesson import SQUARE, PastLesson, Step, past_lesson
from tests.e2e.test_unusual_runs import N_USUAL, filmed

TRIED: list[Step] = [("move_forward", 1), ("turn", 80)] * 4
CALIBRATED = "Pioneer da sala 3"
FAR: list[Step] = [("move_forward", 9)]


class Real(NamedTuple):
    """A lesson with a real robot, runs of it that were measured, and one that is out of the ordinary."""

    lesson: str
    measured: list[str]
    unusual: str


class Past(NamedTuple):
    """The generated lesson."""

    lesson: str
    group: str
    program: str
    versions: tuple[str, str]
    runs: tuple[str, str]
    real: Real


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
        group = lesson.store.programs.get(program).group_id
        first_and_last = (versions[0], versions[-1]), (runs[0], runs[-1])
        return Past(lesson.lesson, group, program, *first_and_last, _play_real(lesson))


def _play_real(lesson: PastLesson) -> Real:
    """Writes a lesson of another class, on a real robot that somebody pushes once; a third class has had none."""
    store = lesson.store
    lesson.at(120)
    lesson.classroom = store.classrooms.create("8º C").id
    lesson.lesson = store.lessons.open(lesson.classroom, "Robô de verdade", None).id
    store.classrooms.create("6º D")
    group = lesson.group("Botos")
    version = group.edit(*SQUARE)
    pushed = [None] * N_USUAL + [(5, -20.0)]
    runs = [filmed(lesson, group, version, 121 + place, one) for place, one in enumerate(pushed)]
    measured = measured_pattern(store, version_id=version)
    return Real(lesson.lesson, measured, runs[-1])


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


def readme(camera: Photographer, past: Past) -> None:
    """Takes the pictures of README and manual: the lesson, and a run of it on the projector."""
    enter(camera)
    camera.go(f"#/lesson/{past.lesson}")
    camera.of("review-group").first.wait_for()
    camera.save("lesson")
    camera.go(f"#/present/same/{past.runs[0]}")
    camera.of("presentation").wait_for()
    camera.page.keyboard.press("PageDown")
    camera.page.wait_for_timeout(1_500)
    camera.save("projector")


def enter(camera: Photographer) -> None:
    """Sets the PIN, or enters it."""
    if camera.call("GET", "/api/teacher")["has_pin"]:
        camera.call("POST", "/api/teacher/enter", {"pin": PIN})
    else:
        camera.call("PUT", "/api/teacher/pin", {"pin": PIN})
    camera.page.reload()


def calibrate(camera: Photographer, past: Past) -> None:
    """Makes a calibrated robot of the measured runs of a real one, for the groups to choose."""
    enter(camera)
    camera.call("POST", "/api/calibrated-robots", {"runs": past.real.measured, "title": CALIBRATED})
    camera.call("POST", "/api/teacher/leave")


def share(camera: Photographer, stick: Path) -> None:
    """Writes the work of this PC to a folder, beside a file that cannot be read."""
    enter(camera)
    camera.call("PUT", "/api/folders/shared", {"path": str(stick)})
    camera.call("POST", "/api/bundles", {"folder": str(stick)})
    (stick / "estragado.pinel").write_bytes(b"SQLite format 3")
    camera.call("POST", "/api/teacher/leave")
