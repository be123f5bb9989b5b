"""Every message a person can meet, by code, in every language.

`catalogue/LANGUAGE/AREA.json` maps a code to its words in one language, a code on each line:

    "distance_out_of_range": {"message": "...{value}...", "remedy": "..."},

The folders are the languages there are. The page reads the same files. Placeholders such as `{value}` are replaced
one by one, never through a format string, because their values come out of pupils' programs.
"""

import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Protocol

_CATALOGUE = resources.files(__name__) / "catalogue"
# the one that every other is translated from, and that a missing word is taken from
FIRST = "pt-BR"
LANGUAGES = (FIRST, *sorted({folder.name for folder in _CATALOGUE.iterdir()} - {FIRST}))
_PLACEHOLDER = re.compile(r"\{(\w+)\}")
_LONGEST = 80
# of a file the end is what tells it from others, and a person may have to type it
_PLACES = frozenset({"file", "files", "folder", "path"})
_LONGEST_PLACE = 1000


@dataclass(frozen=True, slots=True)
class Words:
    """What went wrong and what to do about it, in one language."""

    message: str
    remedy: str

    @property
    def line(self) -> str:
        """Both on one line."""
        return f"{self.message} {self.remedy}".strip()


class Problem(Protocol):
    """A code and what fills its words: a PinelError, a StoreError, a fault or a notice of the store."""

    @property
    def code(self) -> str: ...

    @property
    def params(self) -> Mapping[str, object]: ...


@cache
def catalogue(language: str) -> dict[str, dict[str, str]]:
    """All codes of all areas in one language: code -> {"message", "remedy"}."""
    merged: dict[str, dict[str, str]] = {}
    for file in sorted((_CATALOGUE / language).iterdir(), key=lambda entry: entry.name):
        merged.update(json.loads(file.read_text("utf-8")))
    return merged


def language_of_system() -> str:
    """The language of PINEL_LANG or of the locale; Portuguese where neither is one of ours."""
    for variable in ("PINEL_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        for language in LANGUAGES:
            if os.environ.get(variable, "").lower().startswith(language[:2]):
                return language
    return FIRST


def decimal_sign(language: str) -> str:
    """What stands before the decimals of a number."""
    return catalogue(language)["decimal_sign"]["message"]


def describe(code: str, params: Mapping[str, object], language: str) -> Words:
    """The words for `code` with its placeholders filled; an unknown code is shown as it is."""
    unknown = {"message": code, "remedy": ""}
    words = catalogue(language).get(code) or catalogue(FIRST).get(code) or unknown

    def fill(match: re.Match[str]) -> str:
        name = match[1]
        return _show(params[name], language, name in _PLACES) if name in params else match[0]

    return Words(
        message=_PLACEHOLDER.sub(fill, words["message"]),
        remedy=_PLACEHOLDER.sub(fill, words.get("remedy", "")),
    )


def explain(problem: Problem, language: str | None = None) -> Words:
    """The words for a problem, in that language or the system's."""
    return describe(problem.code, problem.params, language or language_of_system())


def _show(value: object, language: str, is_place: bool = False) -> str:
    if isinstance(value, bool) or value is None:
        return json.dumps(value)
    if isinstance(value, float | int):
        text = f"{value:.10g}" if abs(value) < 1e300 else str(value)[:20]
        return text.replace(".", decimal_sign(language))
    if isinstance(value, list | tuple):
        return ", ".join(_show(item, language, is_place) for item in value)
    text = str(value)
    longest = _LONGEST_PLACE if is_place else _LONGEST
    return text if len(text) <= longest else text[: longest - 1] + "…"
