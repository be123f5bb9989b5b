from typing import Annotated, Any, Literal

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase, CheckResult, FormField
from pinel_desktop.activities.evidence import Evidence


class ShowsText(CheckBase):
    """The program shows a text that contains `text`; case is ignored."""

    requires = None
    form = (FormField("text", "text"),)
    check: Literal["says"]
    text: Annotated[str, Field(min_length=1, max_length=1000)]

    def evaluate(self, evidence: Evidence) -> CheckResult:
        target = self.text.casefold()
        passed = any(target in one.casefold() for one in evidence.shown_texts)
        last = evidence.shown_texts[-1] if evidence.shown_texts else ""
        pointer, values = evidence.last_pointer_of("say"), {"text": self.text}
        return CheckResult(passed, last, self.text, pointer, "check_says", values)

    @classmethod
    def proposed(cls, solution: Evidence) -> dict[str, Any] | None:
        return {"text": solution.shown_texts[0]} if solution.shown_texts else None
