"""A finished lesson, the app on its database, and operation of the teacher's page."""

from typing import NamedTuple

from playwright.sync_api import Locator, expect

from tests.e2e.past_lesson import SQUARE, PastLesson
from tests.e2e.studio import Studio

PIN = "314159"
LONG_NAME = "Tatus da Silva Xavier e o Robô Que Não Parava na Parede"


class Past(NamedTuple):
    """Content of the database: groups by name, runs in the order of the timeline."""

    lesson: str
    empty: str
    group: str
    runs: list[str]


def play(lesson: PastLesson) -> Past:
    """Two groups: one runs, fails, stops and repairs its program, the other only edits."""
    lesson.at(2)
    bees = lesson.group("Abelhas")
    bees.edit(("turn", 90))
    lesson.at(5)
    tatus = lesson.group(LONG_NAME)
    tatus.edit(("move_forward", 1))
    lesson.at(5.5)
    tatus.edit(("move_forward", 9), ("turn", 90))
    lesson.at(6)
    crashed = tatus.run()
    tatus.judged(crashed, passed=False)
    lesson.at(7)
    stopped = tatus.run(stop_at_s=1.0)
    tatus.judged(stopped, passed=False)
    lesson.at(20)
    tatus.edit(*SQUARE)
    lesson.at(21)
    passed = tatus.run()
    tatus.judged(passed, passed=True)
    lesson.at(22)
    store = lesson.store
    empty = store.lessons.open(store.classrooms.create("8º A").id, "Vazia").id
    return Past(lesson.lesson, empty, tatus.id, [crashed, stopped, passed])


class Teacher:
    """The teacher's page, signed in."""

    def __init__(self, studio: Studio, past: Past) -> None:
        self.studio, self.page, self.past = studio, studio.page, past

    def __getitem__(self, test_id: str) -> Locator:
        return self.studio[test_id]

    def go(self, place: str) -> None:
        self.page.goto(f"{self.page.url.split('#')[0]}#/{place}")

    def open_lesson(self) -> None:
        self.go(f"lesson/{self.past.lesson}")
        expect(self["review-group"]).to_have_count(2)

    def row(self, name: str) -> Locator:
        return self.page.locator(f"[data-testid=review-group][data-name='{name}']")

    def marks(self, name: str) -> list[str]:
        marks = self.row(name).get_by_test_id("review-entry").all()
        return [
            one.get_attribute("data-outcome") or one.get_attribute("data-kind") or ""
            for one in marks
        ]

    def filter(self, name: str) -> Locator:
        return self.page.locator(f"[data-testid=history-filter][data-name={name}]")


def sign_in(studio: Studio) -> None:
    """Sets the PIN, or enters it if there is one."""
    expect(studio["group-card"].first).to_be_visible()
    studio.open_teacher_part(PIN)
