from typing import Literal

from pinel_desktop.activities.checks.base import CheckBase, CheckResult
from pinel_desktop.activities.evidence import Evidence


class SignShown(CheckBase):
    """Somebody shows a sign or number that the program reads; inputs of a case count as shown, also without a sign."""

    requires = None
    check: Literal["sign_shown"]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        shown = any(one["result"] or one.get("by") == "list" for one in evidence.captured)
        pointer = evidence.last_pointer_of("classify_gestures", "read_number")
        return CheckResult(shown, float(shown), 1.0, pointer, "check_sign_shown")
