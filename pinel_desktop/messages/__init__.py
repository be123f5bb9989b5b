"""Messages for people: by code, in every language.

`catalogue/LANGUAGE/AREA.json` maps codes to messages in one language, a code on each line:

    "distance_out_of_range": {"message": "...{{value}}...", "remedy": "..."},

The form is i18next JSON v4, which translators' tools read. A plural has a text for each form. The first number in
the general form (`other`) chooses among them:

    "merged": {"message_one": "{{count}} run came.", "message_other": "{{count}} runs came.", "remedy": ""},

`language.json` has the language's name, its plural rule and its words for Python's keywords; `page/` has the texts of
the page, which reads the messages too. The folders of `catalogue` define which languages exist. Placeholders are
replaced one by one, never by a format string, because their values come from pupils' programs. `{{command}}` is the
command of this program as it works in a terminal of this PC.
"""

import gettext
import json
import os
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import resources
from typing import Any, Protocol

from pinel_desktop.command_name import command_name

_CATALOGUE = resources.files(__name__) / "catalogue"
# the other languages are translated from it; it is the fallback for a missing code
SOURCE_LANGUAGE = "pt-BR"
LANGUAGES = (
    SOURCE_LANGUAGE,
    *sorted({folder.name for folder in _CATALOGUE.iterdir()} - {SOURCE_LANGUAGE}),
)
_PLACEHOLDER = re.compile(r"\{\{(\w+)\}\}")
# written by `storage.text.local_time`
_TIME_PARAMS = frozenset({"made_at", "time"})
_TIMESTAMP = re.compile(
    r"(?P<year>\d{4})-(?P<month>\d\d)-(?P<day>\d\d) (?P<hour>\d\d:\d\d)", re.ASCII
)
_MAX_LENGTH = 80
# paths are cut later than other values: their end tells them apart, and a person may have to type them
_PATH_PARAMS = frozenset({"file", "files", "folder", "path"})
_MAX_PATH_LENGTH = 1000


@dataclass(frozen=True, slots=True)
class LocalizedMessage:
    """A message in one language.

    Attributes:
        message: what went wrong.
        remedy: what a person can do about it.
        details: what only a technician can do about it, with paths and options; mostly empty.
    """

    message: str
    remedy: str
    details: str = ""

    @property
    def full_remedy(self) -> str:
        """Remedy and details on one line, for the command line."""
        return f"{self.remedy} {self.details}".strip()

    @property
    def line(self) -> str:
        """Message, remedy and details on one line."""
        return f"{self.message} {self.full_remedy}".strip()


class Problem(Protocol):
    """A code with the values of its placeholders: PinelError, StoreError, a fault, or a notice of the store."""

    @property
    def code(self) -> str: ...

    @property
    def params(self) -> Mapping[str, object]: ...


@cache
def catalogue(language: str) -> dict[str, dict[str, str]]:
    """All codes of all areas in one language: code -> {"message", "remedy"}."""
    merged: dict[str, dict[str, str]] = {}
    for file in sorted((_CATALOGUE / language).iterdir(), key=lambda entry: entry.name):
        if file.is_file() and file.name != "language.json":
            merged.update(json.loads(file.read_text("utf-8")))
    return merged


@cache
def plural_rules(language: str) -> dict[str, Callable[[int], int]]:
    """The plural forms of a language with their conditions, besides the general form "other".

    The conditions are C expressions of `n`, as in gettext's files; a test compares them with the browser's rules.
    """
    conditions: dict[str, str] = _language_file(language)["plural"]
    return {form: gettext.c2py(condition) for form, condition in conditions.items()}


def python_keywords() -> dict[str, str]:
    """What pupils may type for a keyword of Python, in every language: translation -> keyword."""
    return {
        translation: keyword
        for language in LANGUAGES
        for keyword, translations in _language_file(language)["python"].items()
        for translation in translations
    }


def _language_file(language: str) -> dict[str, Any]:
    content: dict[str, Any] = json.loads(
        (_CATALOGUE / language / "language.json").read_text("utf-8")
    )
    return content


def language_of_system() -> str:
    """The language of PINEL_LANG, else of the locale, else of Windows, else Portuguese."""
    for name in _locale_names():
        for language in LANGUAGES:
            if name.lower().startswith(language[:2]):
                return language
    return SOURCE_LANGUAGE


def _locale_names() -> Iterator[str]:
    for variable in ("PINEL_LANG", "LC_ALL", "LC_MESSAGES", "LANG"):
        yield os.environ.get(variable, "")
    if sys.platform == "win32":  # where these variables are rare
        import ctypes  # noqa: PLC0415 - only on Windows
        import locale  # noqa: PLC0415

        yield locale.windows_locale.get(ctypes.windll.kernel32.GetUserDefaultUILanguage(), "")


def decimal_sign(language: str) -> str:
    """The decimal separator: "," or "."."""
    return catalogue(language)["decimal_sign"]["message"]


def describe(code: str, params: Mapping[str, object], language: str) -> LocalizedMessage:
    """The message for `code` with its placeholders filled; for an unknown code, the code itself."""
    unknown = {"message": code, "remedy": ""}
    texts = catalogue(language).get(code) or catalogue(SOURCE_LANGUAGE).get(code) or unknown
    params = _rounded(_without_sides(params))

    def fill(match: re.Match[str]) -> str:
        name = match[1]
        if name == "command":
            return command_name()
        if name not in params:
            return match[0]
        if name in _TIME_PARAMS and (moment := _TIMESTAMP.fullmatch(str(params[name]))):
            form = catalogue(language)["moment"]["message"]
            return _PLACEHOLDER.sub(lambda part: moment[part[1]], form)
        return _show(params[name], language, name in _PATH_PARAMS)

    return LocalizedMessage(
        message=_PLACEHOLDER.sub(fill, _form(texts, "message", params, language)),
        remedy=_PLACEHOLDER.sub(fill, _form(texts, "remedy", params, language)),
        details=_PLACEHOLDER.sub(fill, _form(texts, "details", params, language)),
    )


def _form(texts: Mapping[str, str], part: str, params: Mapping[str, object], language: str) -> str:
    """The text of a part of a message. Of a plural it is the form for the first number in its general form."""
    if (whole := texts.get(part)) is not None:
        return whole
    general = texts.get(f"{part}_other", "")
    counts = (params.get(name) for name in _PLACEHOLDER.findall(general))
    count = next((one for one in counts if isinstance(one, int)), None)
    if count is None:
        return general
    forms = (form for form, holds in plural_rules(language).items() if holds(count))
    names = [*(["zero"] if count == 0 else []), *forms]
    return next((texts[f"{part}_{name}"] for name in names if f"{part}_{name}" in texts), general)


def _without_sides(params: Mapping[str, object]) -> Mapping[str, object]:
    """How much of a motion was done, without the sign that says to which side: "77 of 90", not "-77 of -90"."""
    amount = params.get("amount")
    if "unit" not in params or not isinstance(amount, int | float) or amount >= 0:
        return params
    sides = {name: params[name] for name in ("done", "amount") if name in params}
    return {**params, **{k: -v for k, v in sides.items() if isinstance(v, int | float)}}


def _rounded(params: Mapping[str, object]) -> Mapping[str, object]:
    """Measured lengths in two decimals, as the page shows them; numbers of the program stay as they are written."""
    measured = {name: params[name] for name in ("done", "away") if name in params}
    return {**params, **{k: round(v, 2) for k, v in measured.items() if isinstance(v, float)}}


def explain(problem: Problem, language: str | None = None) -> LocalizedMessage:
    """The message for a problem; `language` defaults to the system's."""
    return describe(problem.code, problem.params, language or language_of_system())


def _show(value: object, language: str, is_path: bool = False) -> str:
    if isinstance(value, bool) or value is None:
        return json.dumps(value)
    if isinstance(value, float | int):
        text = f"{value:.10g}" if abs(value) < 1e300 else str(value)[:20]
        return text.replace(".", decimal_sign(language))
    if isinstance(value, list | tuple):
        return ", ".join(_show(item, language, is_path) for item in value)
    text = str(value)
    max_length = _MAX_PATH_LENGTH if is_path else _MAX_LENGTH
    return text if len(text) <= max_length else text[: max_length - 1] + "…"
