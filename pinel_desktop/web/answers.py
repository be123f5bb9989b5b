"""From models to answers, and from errors to the one error shape."""

import json
from collections.abc import Iterable, Mapping
from typing import Any

from flask import Response
from pydantic import BaseModel

from pinel_desktop.messages import describe
from pinel_desktop.web.models.errors import ErrorAnswer, ErrorBody, Fault

STATUS = {
    "invalid_json": 400,
    "key_missing": 401,
    "secret_wrong": 401,
    "origin_wrong": 403,
    "cross_site": 403,
    "not_found": 404,
    "group_not_found": 404,
    "program_not_found": 404,
    "version_not_found": 404,
    "run_not_found": 404,
    "method_not_allowed": 405,
    "group_exists": 409,
    "run_in_progress": 409,
    "run_not_live": 409,
    "body_too_large": 413,
    "host_wrong": 421,
    "engine_not_ready": 503,
    "database_locked": 503,
    "database_read_only": 503,
    "database_newer": 503,
    "database_foreign": 503,
    "disk_full": 507,
    "database_damaged": 500,
    "database_failed": 500,
    "internal_error": 500,
}
_OTHERWISE = (
    422  # what is left is about the body: a name too long, a world unknown, a program with faults
)


def plain(value: object) -> object:
    """JSON data of a model.

    Not pydantic's dump: that refuses what nests deeper than 255, and Blockly nests each block in the one before.
    """
    if isinstance(value, BaseModel):
        fields = type(value).model_fields
        return {fields[name].alias or name: plain(item) for name, item in value}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return value


def answer(model: BaseModel, status: int = 200) -> Response:
    """The model as JSON."""
    text = json.dumps(plain(model), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return Response(text, status=status, mimetype="application/json")


def in_words(problem: Any, language: str) -> Fault:
    """A fault of a document with its words."""
    words = describe(problem.code, problem.params, language)
    return Fault(
        code=problem.code,
        pointer=problem.pointer,
        block=problem.block,
        message=words.message,
        remedy=words.remedy,
        params=dict(problem.params),
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
    said = describe(words or code, params, language)
    body = ErrorBody(
        code=code,
        message=said.message,
        remedy=said.remedy,
        params=dict(params),
        faults=list(faults),
    )
    return answer(ErrorAnswer(error=body), status or STATUS.get(code, _OTHERWISE))
