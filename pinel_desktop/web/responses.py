"""HTTP responses from models, and error responses from codes."""

import json
import re
from collections.abc import Iterable, Mapping
from itertools import islice
from math import isfinite, log10
from typing import Any

from flask import Response
from pydantic import BaseModel
from pydantic.fields import FieldInfo

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
    "drive_file_missing": 404,
    "taught_sign_not_found": 404,
    "own_activity_not_found": 404,
    "calibrated_robot_not_found": 404,
    "method_not_allowed": 405,
    "group_exists": 409,
    "classroom_exists": 409,
    "sign_taught_enough": 409,
    "signs_too_many": 409,
    "own_activities_too_many": 409,
    "calibrated_robots_too_many": 409,
    "kiosk_not_active": 409,
    "recognizer_of_command": 409,
    "run_in_progress": 409,
    "bridge_busy": 409,
    "run_not_live": 409,
    "prediction_simulated": 409,
    "prediction_no_robot": 409,
    "run_damaged": 409,
    "version_damaged": 409,
    "robot_not_set_up": 409,
    "robot_in_use": 409,
    "cloud_real_robot": 409,
    "cloud_needs_inputs": 409,
    "robot_held_by_keys": 409,
    "body_too_large": 413,
    "host_wrong": 421,
    "pin_wait": 429,
    "engine_not_ready": 503,
    "cloud_lost": 503,
    "engine_silent": 503,
    "stop_unconfirmed": 503,
    "real_stop_unconfirmed": 503,
    "database_locked": 503,
    "database_locked_at_start": 503,
    "database_read_only": 503,
    "database_newer": 503,
    "database_foreign": 503,
    "database_place_missing": 503,
    "database_is_bundle": 503,
    "disk_full": 507,
    "disk_full_at_start": 507,
    "database_damaged": 500,
    "database_failed": 500,
    "internal_error": 500,
}
_DEFAULT_STATUS = 422  # all other codes concern the body, such as a name that is too long


def status_of(code: str) -> int:
    """The HTTP status of an error code."""
    return STATUS.get(code, _DEFAULT_STATUS)


MAX_FAULTS = 100
_LONE_SURROGATE = re.compile("[\ud800-\udfff]")
_MAX_MAGNITUDE = 10**300


def plain(value: object) -> object:
    """Returns the JSON data of a model.

    pydantic's own dump refuses nesting beyond 255. Workspaces exceed it, because Blockly nests each block in the
    previous one.
    """
    if isinstance(value, BaseModel):
        fields = type(value).model_fields
        return {
            _name(fields.get(name), name): plain(item)
            for name, item in value
            if not _is_excluded(fields.get(name), item)
        }
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return value


def _name(field: FieldInfo | None, name: str) -> str:
    return (field and field.alias) or name


def _is_excluded(field: FieldInfo | None, item: object) -> bool:
    return field is not None and field.exclude_if is not None and field.exclude_if(item)


def json_response(model: BaseModel, status: int = 200) -> Response:
    """Returns a JSON response with the model."""
    text = json.dumps(plain(model), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return Response(encodable(text), status=status, mimetype="application/json")


def encodable(text: str) -> str:
    """Replaces lone surrogates, which UTF-8 cannot encode, by U+FFFD."""
    return _LONE_SURROGATE.sub("\ufffd", text)


def json_safe(value: object) -> Any:
    """Converts any value from a document or a request into one that JSON and messages can hold."""
    match value:
        case str():
            return encodable(value)
        case int() if abs(value) > _MAX_MAGNITUDE:
            return f"{'-' if value < 0 else ''}1e{int(value.bit_length() * log10(2))}"
        case float() if not isfinite(value):
            return str(value)
        case Mapping():
            return {encodable(str(name)): json_safe(item) for name, item in value.items()}
        case list() | tuple():
            return [json_safe(item) for item in value]
    return value if value is None or isinstance(value, bool | int | float) else str(value)


def notice(code: str, params: Mapping[str, object], language: str) -> Notice:
    """Returns a message for a person, in the given language."""
    text = describe(code, json_safe(params), language)
    return Notice(code=code, message=text.message, remedy=text.remedy, details=text.details)


def describe_faults(problems: Iterable[Any], language: str) -> list[Fault]:
    """The first `MAX_FAULTS` faults of a document with their messages; more would take time and nobody reads them."""
    return [_describe(problem, language) for problem in islice(problems, MAX_FAULTS)]


def _describe(problem: Any, language: str) -> Fault:
    params = json_safe(problem.params)
    text = describe(problem.code, params, language)
    return Fault(
        code=problem.code,
        pointer=encodable(problem.pointer),
        block=None if problem.block is None else encodable(problem.block),
        message=text.message,
        remedy=text.remedy,
        params=params,
    )


def error_response(
    code: str,
    params: Mapping[str, object],
    language: str,
    *,
    faults: Iterable[Fault] = (),
    status: int | None = None,
    message_code: str | None = None,
) -> Response:
    """Returns an error response with its message in the given language.

    Args:
        status: HTTP status; None is the status of the code.
        message_code: code of a more specific message; None is `code`.
    """
    body = error_body(code, params, language, faults=faults, message_code=message_code)
    return json_response(ErrorAnswer(error=body), status or status_of(code))


def error_body(
    code: str,
    params: Mapping[str, object],
    language: str,
    *,
    faults: Iterable[Fault] = (),
    message_code: str | None = None,
) -> ErrorBody:
    """Returns the body of an error response; `message_code` as in `error_response`."""
    shown = json_safe(params)
    text = describe(message_code or code, shown, language)
    return ErrorBody(
        code=code,
        message=text.message,
        remedy=text.remedy,
        details=text.details,
        params=shown,
        faults=list(faults),
    )
