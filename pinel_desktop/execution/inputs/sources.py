"""Sources of inputs: a person or a camera in real time, a list, or the record of a run (`runs/recorded_inputs.py`)."""

from collections.abc import Callable, Iterable
from enum import Enum
from typing import Protocol

from pinel_desktop.execution.failure import RunFailureError


class Pending(Enum):
    """There is no input yet: what has to pass before the source is asked again.

    TICK: a tick of robot time.
    PERSON: real time. In a simulator robot time stands still; a real robot's ticks go on.
    """

    TICK = "tick"
    PERSON = "person"


class InputSource(Protocol):
    """Gives one input at a time: the result of a capture, or the answer to a question."""

    def begin(self, question: str) -> None:
        """The program waits from now on; earlier inputs are forgotten. `question` is "" for a capture."""

    def poll(self) -> str | Pending:
        """The input, or what has to pass before the next poll. May raise RunFailureError."""
        ...

    def cancel(self) -> None:
        """The program waits no longer, answered or not."""


class Inputs(Protocol):
    """All inputs of one run.

    Attributes:
        is_live: whether a person or a camera gives them, which takes real time.
        gestures: results of captures; "" where nothing was recognised.
        answers: answers to questions, as they were typed.
    """

    is_live: bool

    @property
    def gestures(self) -> InputSource: ...

    @property
    def answers(self) -> InputSource: ...


class Script:
    """Inputs given beforehand, one for each wait, on the next tick.

    Args:
        at_end: what is given when they run out, from the question.
    """

    def __init__(self, inputs: Iterable[str], at_end: Callable[[str], str]) -> None:
        self._inputs, self._at_end = iter(inputs), at_end
        self._question, self._is_due = "", False

    def begin(self, question: str) -> None:
        self._question, self._is_due = question, False

    def poll(self) -> str | Pending:
        if not self._is_due:
            self._is_due = True
            return Pending.TICK
        given = next(self._inputs, None)
        return self._at_end(self._question) if given is None else given

    def cancel(self) -> None:
        return


class ScriptedInputs:
    """Inputs of a run without a person: a capture too many gives "", a question too many fails the run."""

    is_live = False

    def __init__(self, gestures: Iterable[str] = (), answers: Iterable[str] = ()) -> None:
        self.gestures = Script(gestures, lambda _: "")
        self.answers = Script(answers, _missing)

    def attach(self, control: object) -> None:
        """It needs nothing of the run."""


def _missing(question: str) -> str:
    raise RunFailureError("answer_missing", question=question)


class PersonInput:
    """Inputs given by a person or a camera while the program waits; safe to answer from another thread."""

    def __init__(self) -> None:
        self._is_open = False
        self._given: str | None = None
        self._has_waited = False

    def begin(self, question: str) -> None:  # the page knows the question from the event
        self._given, self._has_waited, self._is_open = None, False, True

    def answer(self, given: str) -> None:
        """Answers the running capture or the open question; without one it does nothing."""
        if self._is_open:
            self._given = given

    def poll(self) -> str | Pending:
        """Waits at least once, so that a replay can do the same."""
        if self._given is None or not self._has_waited:
            self._has_waited = True
            return Pending.PERSON
        return self._given

    def cancel(self) -> None:
        self._is_open = False


class LiveInputs:
    """Inputs that a person or a camera gives while the run waits."""

    is_live = True

    def __init__(self) -> None:
        self.gestures, self.answers = PersonInput(), PersonInput()

    def attach(self, control: object) -> None:
        """It needs nothing of the run."""
