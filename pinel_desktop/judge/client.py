"""The app's side of the judge: starts its process when there is something to judge, asks, waits for the verdict."""

import threading
from collections.abc import Sequence
from concurrent.futures import Future
from dataclasses import fields
from itertools import count

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import CheckLine
from pinel_desktop.judge.messages import Question, Told, Verdict
from pinel_desktop.processes import own_command
from pinel_desktop.processes.messages import Message
from pinel_desktop.processes.owned import OwnedProcess

_START_S = 60.0  # a PC that is busy with the start of the app
_ANSWER_S = 30.0  # the step limit of `activities.checking` ends any program long before


class JudgeClient:
    """Keeps the judge's process; thread-safe. `wake` starts it, before the first question is there.

    Args:
        command: starts the process.
        answer_s: a process that does not answer for so long hangs, and is ended.
    """

    def __init__(self, command: Sequence[str] | None = None, answer_s: float = _ANSWER_S) -> None:
        self._process = OwnedProcess(
            "judge",
            command or own_command("judge"),
            self._receive,
            self._fail_all,
            on_lost=self._fail_all,
        )
        self._answer_s = answer_s
        self._lock = threading.Lock()
        self._numbers = count()
        self._waiting: dict[int, Future[Message]] = {}
        self._awake = self._closed = False

    @property
    def pid(self) -> int | None:
        """Id of the process; None before its start."""
        return self._process.pid

    def wake(self) -> None:
        """Starts the process, and once more one that is lost; returns at once."""
        with self._lock:
            if self._closed or (self._awake and self._process.state != "lost"):
                return
            self._awake = True
        self._process.start()

    def judge(self, question: Question) -> Verdict:
        """Waits for the verdict.

        Raises:
            PinelError: `judge_lost` if the process dies, hangs or does not start, and what judging raises.
        """
        found = self._ask(question.as_message())
        names = [one.name for one in fields(Verdict)]
        return Verdict(**{name: found[name] for name in names})

    def follow(self, told: Told) -> list[CheckLine] | None:
        """How a run that goes on stands with the checks of its activity; None where they are not about it.

        Raises:
            PinelError: as `judge`.
        """
        checks: list[CheckLine] | None = self._ask(told.as_message())["checks"]
        return checks

    def _ask(self, message: Message) -> Message:
        self.wake()
        if not self._process.wait_until_ready(_START_S):
            raise PinelError("judge_lost")
        number, answer = next(self._numbers), Future[Message]()
        with self._lock:
            if self._closed:
                raise PinelError("judge_lost")
            self._waiting[number] = answer
        try:
            if not self._process.send({"question": number, **message}):
                raise PinelError("judge_lost")
            return answer.result(self._answer_s)
        except TimeoutError as error:
            self._process.kill()
            raise PinelError("judge_lost") from error
        finally:
            with self._lock:
                self._waiting.pop(number, None)

    def close(self) -> None:
        """Ends the process; whoever waits for a verdict gets `judge_lost`."""
        with self._lock:
            self._closed = True
        self._fail_all()
        self._process.close()

    def _receive(self, message: Message) -> None:
        with self._lock:
            answer = self._waiting.pop(message["question"], None)
        if answer is None:
            return
        if message["type"] == "refused":
            answer.set_exception(PinelError(message["code"], **message["params"]))
        else:
            answer.set_result(message)

    def _fail_all(self) -> None:
        with self._lock:
            waiting, self._waiting = self._waiting, {}
        for answer in waiting.values():
            answer.set_exception(PinelError("judge_lost"))
