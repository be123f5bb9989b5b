"""Input sources: a person or a camera in real time, or a list; for recorded runs see `runs/recorded_inputs.py`."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Generic, Protocol, TypeVar

from pinel_desktop.events.model import CaptureBy
from pinel_desktop.execution.failure import RunFailureError

T = TypeVar("T")
Given_co = TypeVar("Given_co", covariant=True)


@dataclass(frozen=True, slots=True)
class Capture:
    """The result of a capture.

    Attributes:
        label: name of the sign; "" if no sign was recognised.
        by: source of the result; None after the timeout.
        confidence: confidence of the camera, 0 to 1; None for other sources.
        second: the camera's second best sign; "" without one.
    """

    label: str
    by: CaptureBy | None = None
    confidence: float | None = None
    second: str = ""


NO_CAPTURE = Capture("")
# The number shown when nobody showed one: no count of fingers, and a program can compare with it.
NO_NUMBER = -1
_NUMBERS = frozenset(map(str, range(11)))


def number_of(capture: Capture) -> int:
    """Returns the number that a capture read, 0 to 10; `NO_NUMBER` for any other sign."""
    return int(capture.label) if capture.label in _NUMBERS else NO_NUMBER


class Pending(Enum):
    """No input yet: the kind of time to let pass before the next poll.

    Attributes:
        TICK: a tick of robot time.
        PERSON: real time. In a simulator robot time stops; a real robot's ticks continue.
    """

    TICK = "tick"
    PERSON = "person"


class InputSource(Protocol[Given_co]):
    """Provides one input at a time: the result of a capture, or the answer to a question."""

    def begin(self, question: str) -> None:
        """Starts a wait and discards earlier inputs. `question` is "" for a capture."""

    def poll(self) -> Given_co | Pending:
        """The input, or `Pending`. May raise RunFailureError."""
        ...

    def cancel(self) -> None:
        """Ends the wait, answered or not."""


class Inputs(Protocol):
    """All inputs of one run.

    Attributes:
        is_live: whether a person or a camera provides them, in real time.
        gestures: results of captures.
        answers: answers to questions, as typed.
    """

    is_live: bool

    @property
    def gestures(self) -> InputSource[Capture]: ...

    @property
    def answers(self) -> InputSource[str]: ...


class Script(Generic[T]):
    """A list of inputs, one for each wait, given on the next tick.

    Args:
        at_end: returns the input for a question after the end of the list.
    """

    def __init__(self, inputs: Iterable[T], at_end: Callable[[str], T]) -> None:
        self._inputs, self._at_end = iter(inputs), at_end
        self._question, self._is_due = "", False

    def begin(self, question: str) -> None:
        self._question, self._is_due = question, False

    def poll(self) -> T | Pending:
        if not self._is_due:
            self._is_due = True
            return Pending.TICK
        given = next(self._inputs, None)
        return self._at_end(self._question) if given is None else given

    def cancel(self) -> None:
        return


class ScriptedInputs:
    """Inputs of a run without a person; past the end a capture gives no sign and a question fails the run.

    Args:
        all_gestures: whether `gestures` are complete. Past their end a capture then fails the run, too: a program
            that waits for another sign would wait for ever.
    """

    is_live = False

    def __init__(
        self,
        gestures: Iterable[str] = (),
        answers: Iterable[str] = (),
        *,
        all_gestures: bool = False,
    ) -> None:
        at_end = _no_more_gestures if all_gestures else _no_sign
        self.gestures = Script((Capture(sign, "list") for sign in gestures), at_end)
        self.answers = Script(answers, _missing)

    def attach(self, control: object) -> None:
        """Does nothing: these inputs do not depend on the run."""


def _no_sign(_question: str) -> Capture:
    return NO_CAPTURE


def _no_more_gestures(_question: str) -> Capture:
    raise RunFailureError("no_more_gestures")


def _missing(question: str) -> str:
    raise RunFailureError("answer_missing", question=question)


class PersonInput(Generic[T]):
    """Input of a person or a camera while the program waits; thread-safe."""

    def __init__(self) -> None:
        self._is_open = False
        self._given: T | None = None
        self._has_waited = False

    def begin(self, question: str) -> None:  # the event carries the question to the page
        self._given, self._has_waited, self._is_open = None, False, True

    def answer(self, given: T) -> None:
        """Answers the current capture or question; without effect if there is none."""
        if self._is_open:
            self._given = given

    def poll(self) -> T | Pending:
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
        self.gestures, self.answers = PersonInput[Capture](), PersonInput[str]()

    def attach(self, control: object) -> None:
        """Does nothing: these inputs do not depend on the run."""
