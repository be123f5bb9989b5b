from typing import Literal

from pinel_desktop.activities.checks.base import CheckBase, CheckResult
from pinel_desktop.activities.evidence import Evidence
from pinel_desktop.runs.spec import INTERRUPTED_REASONS


class Finished(CheckBase):
    """The program ends by itself and without a failure."""

    requires = None
    check: Literal["finished"]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        ended = evidence.log.ended
        state, reason = str(ended["state"]), ended.get("reason")
        values = dict(ended.get("params") or {})
        is_at_block = state != "finished" and reason not in INTERRUPTED_REASONS
        pointer = evidence.running.pointer if evidence.running and is_at_block else None
        code = str(reason) if reason else "check_finished"
        return CheckResult(state == "finished", state, "finished", pointer, code, values)
