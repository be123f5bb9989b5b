"""From models to answers, and from errors to the one error shape."""

import json
import re
from collections.abc import Iterable, Mapping
from itertools import islice
from math import isfinite, log10
from typing import Any

from flask import Response
from pydantic import BaseModel

from pinel_desktop.messages import describe
from pinel_desktop.web.models.errors import ErrorAnswer, ErrorBody, Fault, Notice

STATUS = {
    "invalid_json": 400,
    "key_missing": 401,
    "secret_wrong": 401,
    "origin_wrong": 403,
    "cross_site": 403,
    "teacher_only": 403,
    "pin_missing": 403,
    "pin_wrong": 403,
    "not_found": 404,
    "group_not_found": 404,
    "program_not_found": 404,
    "version_not_found": 404,
    "run_not_found": 404,
    "classroom_not_found": 404,
    "lesson_not_found": 404,
    "note_not_found": 404,
    "method_not_allowed": 405,
    "group_exists": 409,
    "classroom_exists": 409,
    "run_in_progress": 409,
    "run_not_live": 409,
    "body_too_large": 413,
    "host_wrong": 421,
    "pin_wait": 429,
    "engine_not_ready": 503,
    "database_locked": 503,
    "database_read_only": 503,
    "database_newer": 503,
    "database_foreign": 503,
    "database_is_bundle": 503,
    "disk_full": 507,
    "database_damaged": 500,
    "database_failed": 500,
    "run_damaged": 500,
    "internal_error": 500,
}
_OTHERWISE = (
    422  # what is left is about the body: a name too long, a world unknown, a program with faults
)


def status_of(code: str) -> int:
    """The HTTP status of an error."""
    return STATUS.get(code, _OTHERWISE)


MAX_FAULTS = 100
_LONE_SURROGATE = re.compile("[\ud800-\udfff]")
_LARGEST = 10**300


def plain(value: object) -> object:
    """JSON data of a model.

    Not pydantic's dump: that refuses what nests deeper than 255, and Blockly nests each block in the one before.
    """
    if isinstance(value, BaseModel):
        aliases = {name: field.alias or name for name, field in type(value).model_fields.items()}
        return {aliases.get(name, name): plain(item) for name, item in value}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return value


def answer(model: BaseModel, status: int = 200) -> Response:
    """The model as JSON."""
    text = json.dumps(plain(model), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return Response(writable(text), status=status, mimetype="application/json")


def writable(text: str) -> str:
    """The text with a mark in place of lone surrogates, which no encoding can write."""
    return _LONE_SURROGATE.sub("\ufffd", text)


def showable(value: object) -> Any:
    """A value that words and JSON can hold, whatever a document or a request put into it."""
    match value:
        case str():
            return writable(value)
        case int() if abs(value) > _LARGEST:
            return f"{'-' if value < 0 else ''}1e{int(value.bit_length() * log10(2))}"
        case float() if not isfinite(value):
            return str(value)
        case Mapping():
            return {writable(str(name)): showable(item) for name, item in value.items()}
        case list() | tuple():
            return [showable(item) for item in value]
    return value if value is None or isinstance(value, bool | int | float) else str(value)


def notice(code: str, params: Mapping[str, object], language: str) -> Notice:
    """Something that a person should know, in words of the language."""
    words = describe(code, showable(params), language)
    return Notice(code=code, message=words.message, remedy=words.remedy)


def faults_in_words(problems: Iterable[Any], language: str) -> list[Fault]:
    """The first faults of a document with their words: nobody reads more, and each takes its time and place."""
    return [_in_words(problem, language) for problem in islice(problems, MAX_FAULTS)]


def _in_words(problem: Any, language: str) -> Fault:
    params = showable(problem.params)
    words = describe(problem.code, params, language)
    return Fault(
        code=problem.code,
        pointer=writable(problem.pointer),
        block=None if problem.block is None else writable(problem.block),
        message=words.message,
        remedy=words.remedy,
        params=params,
    )


def error_answer(
    code: str,
    params: Mapping[str, object],
    language: str,
    *,
    faults: Iterable[Fault] = (),
    status: int | None = None,
    words: str | None = None,
) -> Response:
    """The one error shape, in words of the language; the status follows from the code.

    Args:
        words: code of the words, where they say more than those of the code itself.
    """
    shown = showable(params)
    said = describe(words or code, shown, language)
    body = ErrorBody(
        code=code,
        message=said.message,
        remedy=said.remedy,
        params=shown,
        faults=list(faults),
    )
    return answer(ErrorAnswer(error=body), status or status_of(code))
