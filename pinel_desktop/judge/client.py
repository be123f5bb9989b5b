"""The app's side of the judge: starts its process when there is something to judge, asks, waits for the verdict."""

from collections.abc import Sequence
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import CheckProgress
from pinel_desktop.judge.messages import JudgeRequest, RunUpdate, Verdict
from pinel_desktop.processes import own_command
from pinel_desktop.processes.heartbeat import HangTimeouts
from pinel_desktop.processes.messages import Message
from pinel_desktop.processes.supervisor import Supervisor

_START_S = 60.0  # a PC that is busy with the start of the app
# It answers probes between two requests; the step limit of `activities.checking` ends any program long before.
_TIMEOUTS = HangTimeouts(hang_timeout_s=30.0, busy_timeout_s=30.0, start_timeout_s=2 * _START_S)
# Grading, the check list and runs of other PCs may ask at once: the last one waits for two that hang.
_RESPONSE_TIMEOUT_S = 90.0


class JudgeClient:
    """Keeps the judge's process; thread-safe. `start` starts it, before the first question is there.

    Args:
        command: starts the process.
        timeouts: of a process that hangs, which is replaced.
    """

    def __init__(
        self, command: Sequence[str] | None = None, timeouts: HangTimeouts = _TIMEOUTS
    ) -> None:
        command = command or own_command("judge")
        self._process = Supervisor("judge", command, "judge_lost", timeouts=timeouts)

    @property
    def pid(self) -> int | None:
        """Id of the process; None before its start."""
        return self._process.pid

    def start(self) -> None:
        """Starts the process, and once more one that is lost; returns at once."""
        self._process.start()

    def judge(self, request: JudgeRequest) -> Verdict:
        """Waits for the verdict.

        Raises:
            PinelError: `judge_lost` if the process dies, hangs or does not start, and what judging raises.
        """
        return Verdict(**self._ask(request.as_message()))

    def evaluate_live(self, run_update: RunUpdate) -> list[CheckProgress] | None:
        """How a run that goes on stands with the checks of its activity; None where they are not about it.

        Raises:
            PinelError: as `judge`.
        """
        checks: list[CheckProgress] | None = self._ask(run_update.as_message())
        return checks

    def _ask(self, message: Message) -> Any:
        self.start()
        if not self._process.wait_until_ready(_START_S):
            raise PinelError("judge_lost")
        try:
            return self._process.request(message, _RESPONSE_TIMEOUT_S)
        except TimeoutError as error:
            raise PinelError("judge_lost") from error

    def close(self) -> None:
        """Ends the process; whoever waits for a verdict gets `judge_lost`."""
        self._process.close()
