"""Every message a person can meet, by code, in Portuguese, English and Spanish.

`catalogue/AREA.json` maps a code to its words, the three languages side by side:

    {"distance_out_of_range": {"pt-BR": {"message": "...{value}...", "remedy": "..."}, "en": {...}, "es": {...}}}

The page reads the same files. Placeholders such as `{value}` are replaced one by one, never through a
format string, because their values come out of pupils' programs.
"""

import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources

LANGUAGES = ("pt-BR", "en", "es")
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


@cache
def catalogue() -> dict[str, dict[str, dict[str, str]]]:
    """All codes of all areas: code -> language -> {"message", "remedy"}."""
    merged: dict[str, dict[str, dict[str, str]]] = {}
    folder = resources.files(__name__) / "catalogue"
    for file in sorted(folder.iterdir(), key=lambda entry: entry.name):
        if file.name.endswith(".json"):
            merged.update(json.loads(file.read_text("utf-8")))
    return merged


def language_of_system() -> str:
    """The language of PINEL_LANG or of the locale; Portuguese where neither is one of ours."""
    for variable in ("PINEL_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        for language in LANGUAGES:
            if os.environ.get(variable, "").lower().startswith(language[:2]):
                return language
    return LANGUAGES[0]


def describe(code: str, params: Mapping[str, object], language: str) -> Words:
    """The words for `code` with its placeholders filled; an unknown code is shown as it is."""
    entry = catalogue().get(code, {})
    words = entry.get(language) or entry.get(LANGUAGES[0]) or {"message": code, "remedy": ""}

    def fill(match: re.Match[str]) -> str:
        name = match[1]
        return _show(params[name], language, name in _PLACES) if name in params else match[0]

    return Words(
        message=_PLACEHOLDER.sub(fill, words["message"]),
        remedy=_PLACEHOLDER.sub(fill, words.get("remedy", "")),
    )


def _show(value: object, language: str, is_place: bool = False) -> str:
    if isinstance(value, bool) or value is None:
        return json.dumps(value)
    if isinstance(value, float | int):
        text = f"{value:.10g}" if abs(value) < 1e300 else str(value)[:20]
        return text if language == "en" else text.replace(".", ",")
    if isinstance(value, list | tuple):
        return ", ".join(_show(item, language, is_place) for item in value)
    text = str(value)
    longest = _LONGEST_PLACE if is_place else _LONGEST
    return text if len(text) <= longest else text[: longest - 1] + "…"
