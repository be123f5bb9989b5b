"""Input sources: a person or a camera in real time, or a list; for recorded runs see `runs/recorded_inputs.py`."""

from collections.abc import Callable, Iterable
from enum import Enum
from typing import Protocol

from pinel_desktop.execution.failure import RunFailureError


class Pending(Enum):
    """No input yet: the kind of time to let pass before the next poll.

    TICK: a tick of robot time.
    PERSON: real time. In a simulator robot time stands still; a real robot's ticks go on.
    """

    TICK = "tick"
    PERSON = "person"


class InputSource(Protocol):
    """Provides one input at a time: the result of a capture, or the answer to a question."""

    def begin(self, question: str) -> None:
        """Begins a wait and discards earlier inputs. `question` is "" for a capture."""

    def poll(self) -> str | Pending:
        """The input, or `Pending`. May raise RunFailureError."""
        ...

    def cancel(self) -> None:
        """Ends the wait, answered or not."""


class Inputs(Protocol):
    """All inputs of one run.

    Attributes:
        is_live: whether a person or a camera provides them, in real time.
        gestures: results of captures; "" if nothing was recognised.
        answers: answers to questions, as typed.
    """

    is_live: bool

    @property
    def gestures(self) -> InputSource: ...

    @property
    def answers(self) -> InputSource: ...


class Script:
    """A list of inputs, one for each wait, given on the next tick.

    Args:
        at_end: returns the input for a question after the end of the list.
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
    """Inputs of a run without a person; past the end a capture gives "" and a question fails the run."""

    is_live = False

    def __init__(self, gestures: Iterable[str] = (), answers: Iterable[str] = ()) -> None:
        self.gestures = Script(gestures, lambda _: "")
        self.answers = Script(answers, _missing)

    def attach(self, control: object) -> None:
        """Does nothing: these inputs do not depend on the run."""


def _missing(question: str) -> str:
    raise RunFailureError("answer_missing", question=question)


class PersonInput:
    """Input of a person or a camera while the program waits; thread-safe."""

    def __init__(self) -> None:
        self._is_open = False
        self._given: str | None = None
        self._has_waited = False

    def begin(self, question: str) -> None:  # the event carries the question to the page
        self._given, self._has_waited, self._is_open = None, False, True

    def answer(self, given: str) -> None:
        """Answers the current capture or question; without effect if there is none."""
        if self._is_open:
            self._given = given

    def poll(self) -> str | Pending:
        """Waits at least once, so that a replay can reproduce the wait."""
        if self._given is None or not self._has_waited:
            self._has_waited = True
            return Pending.PERSON
        return self._given

    def cancel(self) -> None:
        self._is_open = False


class LiveInputs:
    """Inputs of a person or a camera during the run."""

    is_live = True

    def __init__(self) -> None:
        self.gestures, self.answers = PersonInput(), PersonInput()

    def attach(self, control: object) -> None:
        """Does nothing: these inputs do not depend on the run."""
