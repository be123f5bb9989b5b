"""What was said about a run that did not pass its activity, read from the report that was kept of it."""

import re
from typing import Annotated

from pydantic import BaseModel, Field, TypeAdapter, ValidationError

_NUMBER = re.compile(r"[0-9]+")


class Advice(BaseModel):
    """What a group was told.

    Attributes:
        diagnosis: its place in the activity; None for the words of a check.
        words: by language.
    """

    diagnosis: int | None = None
    words: Annotated[dict[str, str], Field(min_length=1)]

    def mistake(self, activity: str) -> str:
        """Key that is equal for equal mistakes: words of checks differ in numbers."""
        if self.diagnosis is not None:
            return f"{activity} {self.diagnosis}"
        return f"{activity} {_NUMBER.sub('#', self.words[min(self.words)])}"

    def of(self, language: str) -> str:
        """The words in a language; a report of another release may have others."""
        return self.words.get(language, self.words[min(self.words)])


_CASES: TypeAdapter[list[Advice | None]] = TypeAdapter(list[Advice | None])


def advice_of_cases(of_cases: str | None) -> Advice | None:
    """The advice that was said about all cases: the first diagnosis, else the words of the first check.

    Args:
        of_cases: JSON list with the advice about each case, as `storage` hands it out; a damaged one is none.
    """
    try:
        cases = _CASES.validate_json(of_cases or "[]")
    except ValidationError:
        return None
    given = [one for one in cases if one is not None]
    return min(given, key=_rank, default=None)


def _rank(advice: Advice) -> float:
    return float("inf") if advice.diagnosis is None else advice.diagnosis
