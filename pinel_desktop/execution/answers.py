"""Where the answers to a program's questions come from, as the executor sees it."""

from collections.abc import Iterable
from typing import Protocol

from pinel_desktop.execution.failure import RunFailureError


class AnswerSource(Protocol):
    """Asks one question at a time: a list, or a person at the page."""

    def begin(self, question: str) -> None:
        """A question is asked; earlier answers are forgotten."""

    def poll(self) -> str | None:
        """The answer as it was typed, or None while there is none yet. May raise RunFailureError."""
        ...

    def cancel(self) -> None:
        """The question is over, answered or not."""


class ScriptedAnswers:
    """Answers given beforehand, one per question, on the next tick; a question too many fails the run."""

    def __init__(self, answers: Iterable[str] = ()) -> None:
        self._answers = iter(answers)
        self._question = ""

    def begin(self, question: str) -> None:
        self._question = question

    def poll(self) -> str | None:
        answer = next(self._answers, None)
        if answer is None:
            raise RunFailureError("answer_missing", question=self._question)
        return answer

    def cancel(self) -> None:
        return


class LiveAnswers:
    """Answers given by a person while the program waits; safe to answer from another thread."""

    def __init__(self) -> None:
        self._open = False
        self._answer: str | None = None

    def begin(self, question: str) -> None:  # the page knows the question from the event
        self._answer, self._open = None, True

    def answer(self, text: str) -> None:
        """Answers the open question; without one it says nothing."""
        if self._open:
            self._answer = text

    def poll(self) -> str | None:
        return self._answer

    def cancel(self) -> None:
        self._open = False
