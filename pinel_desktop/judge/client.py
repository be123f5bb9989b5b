"""The app's client of the judge process: starts it on demand, sends requests, waits for verdicts, ends it if idle."""

from collections.abc import Sequence
from typing import Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.app_events import CheckProgress
from pinel_desktop.judge.messages import (
    JudgeRequest,
    PredictedRun,
    PredictionRequest,
    RunUpdate,
    Verdict,
)
from pinel_desktop.processes import own_command
from pinel_desktop.processes.heartbeat import HangTimeouts
from pinel_desktop.processes.messages import Message
from pinel_desktop.processes.supervisor import Supervisor

_START_S = 60.0  # long, because the start of the app may keep the PC busy
# The judge answers probes between two requests only. The step limit of `activities.checking` ends
# every program long before these timeouts.
_TIMEOUTS = HangTimeouts(hang_timeout_s=30.0, busy_timeout_s=30.0, start_timeout_s=2 * _START_S)
# Grading, the check list and runs of other PCs may send a request each at the same time. The last
# request then waits for two requests that hang.
_RESPONSE_TIMEOUT_S = 90.0
IDLE_END_S = 300.0


class JudgeClient:
    """Client of the judge process; thread-safe. `start` starts the process before the first request.

    Args:
        command: command line that starts the process.
        timeouts: after these timeouts a hung process is replaced.
        idle_end_s: time after the last request until the process ends.
    """

    def __init__(
        self,
        command: Sequence[str] | None = None,
        timeouts: HangTimeouts = _TIMEOUTS,
        idle_end_s: float = IDLE_END_S,
    ) -> None:
        command = command or own_command("judge")
        self._process = Supervisor(
            "judge", command, "judge_lost", timeouts=timeouts, idle_end_s=idle_end_s
        )

    @property
    def pid(self) -> int | None:
        """Id of the process; None while it does not run."""
        return self._process.pid

    def start(self) -> None:
        """Starts the process, or restarts a lost process; returns at once."""
        self._process.start()

    def judge(self, request: JudgeRequest) -> Verdict:
        """Sends a request and waits for the verdict.

        Raises:
            PinelError: `judge_lost` if the process dies, hangs or does not start; any error of the judging itself.
        """
        return Verdict(**self._ask(request.as_message()))

    def evaluate_live(self, run_update: RunUpdate) -> list[CheckProgress] | None:
        """Returns the check list of a live run; None if the checks of its activity do not apply to it.

        Raises:
            PinelError: as `judge`.
        """
        checks: list[CheckProgress] | None = self._ask(run_update.as_message())
        return checks

    def predict(self, request: PredictionRequest) -> PredictedRun:
        """Returns the prediction of a real robot's run, and the run beside it.

        Raises:
            PinelError: as `judge`, and any error of `runs.prediction.predict`.
        """
        return PredictedRun(**self._ask(request.as_message()))

    def _ask(self, message: Message) -> Any:
        self.start()
        if not self._process.wait_until_ready(_START_S):
            raise PinelError("judge_lost")
        try:
            return self._process.request(message, _RESPONSE_TIMEOUT_S)
        except TimeoutError as error:
            raise PinelError("judge_lost") from error

    def close(self) -> None:
        """Ends the process; pending requests raise `judge_lost`."""
        self._process.close()
