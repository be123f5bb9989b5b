"""Diagnosis or check text shown for a run that did not pass its activity, read from the stored report."""

import re
from collections.abc import Mapping, Sequence
from typing import Annotated, Any

from pydantic import BaseModel, Field, TypeAdapter, ValidationError

_NUMBER = re.compile(r"[0-9]+")


class Advice(BaseModel):
    """The text that a group was shown about its run.

    Attributes:
        diagnosis: index of the diagnosis in the activity; None for the text of a check.
        words: the text by language.
        block: id of the block that it is about; None without one.
    """

    diagnosis: int | None = None
    block: str | None = None
    words: Annotated[dict[str, str], Field(min_length=1)]

    def mistake(self, activity: str) -> str:
        """Returns a key that is equal for equal mistakes; texts of checks are compared without their numbers."""
        if self.diagnosis is not None:
            return f"{activity} {self.diagnosis}"
        return f"{activity} {_NUMBER.sub('#', self.words[min(self.words)])}"

    def of(self, language: str) -> str:
        """Returns the text in a language, or in another one if the report of another release lacks it."""
        return self.words.get(language, self.words[min(self.words)])


class _Case(BaseModel):
    advice: Advice | None = None


class _Report(BaseModel):
    cases: list[_Case] = []


_CASES: TypeAdapter[list[Advice | None]] = TypeAdapter(list[Advice | None])


def advice_of_cases(of_cases: str | None) -> Advice | None:
    """Returns the advice for a whole run: its first diagnosis, else the text of its first check.

    Args:
        of_cases: JSON list with the advice for each case, as `storage` returns it; a damaged list counts as empty.
    """
    try:
        return _first(_CASES.validate_json(of_cases or "[]"))
    except ValidationError:
        return None


def advice_of_report(report: Mapping[str, Any]) -> Advice | None:
    """Returns the advice in the stored report of a run; None if it has none or is damaged."""
    try:
        return _first([case.advice for case in _Report.model_validate(report).cases])
    except ValidationError:
        return None


def _first(cases: Sequence[Advice | None]) -> Advice | None:
    given = [one for one in cases if one is not None]
    return min(given, key=_rank, default=None)


def _rank(advice: Advice) -> float:
    return float("inf") if advice.diagnosis is None else advice.diagnosis
