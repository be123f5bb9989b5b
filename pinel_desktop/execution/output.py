"""A program's output besides motion: texts, marks, beeps, pen, questions; each limited per run."""

from collections.abc import Callable
from typing import Literal

from pinel_desktop.events.model import Beeped, Event, Marked, Pen, TextShown
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.execution.limits import MAX_BEEPS, MAX_MARKS, MAX_QUESTIONS, MAX_SHOWN_TEXTS

DEFAULT_COLOR = "blue"


class Output:
    """Reports output as events, and collects texts, marks and beeps for the end of the run.

    A loop without motion may produce a thousand outputs a tick: exceeding a limit fails the run. The pen is reported
    once a tick, because only motion draws.
    """

    def __init__(self, emit: Callable[[Event], None]) -> None:
        self.shown_texts: list[str] = []
        self.marks: list[Marked] = []
        self._emit = emit
        self.n_beeps = 0
        self._n_questions = 0
        self._pen: tuple[bool, str] = (False, DEFAULT_COLOR)
        self._reported_pen = self._pen
        self._pen_block: str | None = None

    def show_text(self, block: str | None, text: str) -> None:
        """Shows a text. Raises RunFailureError `too_many_said`."""
        if len(self.shown_texts) >= MAX_SHOWN_TEXTS:
            raise RunFailureError("too_many_said", max=MAX_SHOWN_TEXTS)
        self.shown_texts.append(text)
        self._emit(TextShown(block, text))

    def mark(self, block: str | None, symbol: Literal["X", "O"], x_m: float, y_m: float) -> None:
        """Marks a point of the floor, in the start frame. Raises RunFailureError `too_many_marks`."""
        if len(self.marks) >= MAX_MARKS:
            raise RunFailureError("too_many_marks", max=MAX_MARKS)
        self.marks.append(Marked(block, symbol, x_m, y_m))
        self._emit(self.marks[-1])

    def beep(self, block: str | None) -> None:
        """Beeps. Raises RunFailureError `too_many_beeps`."""
        if self.n_beeps >= MAX_BEEPS:
            raise RunFailureError("too_many_beeps", max=MAX_BEEPS)
        self.n_beeps += 1
        self._emit(Beeped(block))

    def question(self) -> None:
        """Counts a question. Raises RunFailureError `too_many_questions`."""
        if self._n_questions >= MAX_QUESTIONS:
            raise RunFailureError("too_many_questions", max=MAX_QUESTIONS)
        self._n_questions += 1

    def pen(self, block: str | None, *, down: bool, color: str | None) -> None:
        """Lowers or raises the pen; reported with the next tick."""
        self._pen, self._pen_block = (down, color or DEFAULT_COLOR), block

    def report_pen(self) -> None:
        """Reports a changed pen; called before each tick."""
        if self._pen != self._reported_pen:
            self._reported_pen = self._pen
            self._emit(Pen(self._pen_block, *self._pen))
