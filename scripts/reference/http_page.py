"""Generates docs/http-api.md from the OpenAPI description."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any

from pinel_desktop.messages import describe
from pinel_desktop.web.api import TEACHER, WRITES
from pinel_desktop.web.description import description
from pinel_desktop.web.models.runs import RunEvents
from pinel_desktop.web.responses import MAX_FAULTS, STATUS
from scripts.reference.schema_words import field_table, kind

_HEAD = f"""\
# HTTP interface

The interface between the page and the app: JSON under `/api`. A body has at most 4 MiB, a program's file at most
64 MiB. Ids are UUID text. Times are ISO 8601 text in UTC, by the clock of the PC that recorded them. Paged lists have
`next`, the value of `before` for the next page, null at the end. Unknown keys of a body or a query are refused.

This text and the page's TypeScript types are generated from the handlers and pydantic models in `pinel_desktop/web`.
The app serves the same description as OpenAPI 3.1 at `/api/openapi.json`. `python -m scripts.reference` writes this
text.

## Access

The server is bound to 127.0.0.1. A one-time key in the first address (`/?key=...`) sets an HttpOnly, SameSite=Strict
cookie and redirects to `/`. The cookie is called `pinel_PORT`, because cookies are shared by all ports. Every request
must carry it and come from our own page. Every answer has a strict Content-Security-Policy; nothing is loaded from
elsewhere. Routes under `/api/instance` are for a second start of the app on the same data; they need the header
`X-Pinel-Secret` instead of the cookie.

Routes marked **For the teacher** also need the cookie of a teacher's session (`pinel_desktop/school/teacher.py`);
without it they answer 403 `teacher_only`, or `pin_missing` before a PIN is set.

## Errors

Every answer with a status of 400 and above is `{{"error": {{"code", "message", "remedy", "params", "faults"}}}}`, with
the message in the chosen language. `faults` lists the faults of a document with their places, at most the first
{MAX_FAULTS}.

Any route may answer:
"""
_ANYWHERE = (
    *("invalid_json", "key_missing", "secret_wrong", "origin_wrong", "cross_site", "not_found"),
    *("method_not_allowed", "host_wrong", "body_too_large", "internal_error"),
    *("database_newer", "database_foreign", "database_is_bundle", "database_damaged"),
    *("database_failed", "run_damaged"),
)
_METHODS = ("get", "post", "put", "patch", "delete")
_NOT_OBJECTS = ("ErrorAnswer", "ErrorBody", "ValidationErrorModel")


def text() -> str:
    """The whole page as Markdown."""
    document = description()
    parts = [_HEAD, *_errors_anywhere(), "## Routes\n"]
    for tag in document["tags"]:
        parts += [f"### {tag['description'].rstrip('.')}\n", *_routes(document, tag["name"])]
    parts += ["## Objects\n", *_objects(document["components"]["schemas"])]
    return "\n".join(parts).rstrip() + "\n"


def _errors_anywhere() -> Iterator[str]:
    yield "| status | code | message |\n|---|---|---|"
    for code in sorted(_ANYWHERE, key=lambda code: (STATUS[code], code)):
        yield _error(code)
    yield "| 422 | `invalid_request` | The body or the query does not fit; the message names the first place. |\n"
    yield "A route that writes to the database may also answer:\n"
    yield "| status | code | message |\n|---|---|---|"
    for code in WRITES:
        yield _error(code)
    yield ""


def _error(code: str) -> str:
    return f"| {STATUS[code]} | `{code}` | {describe(code, {}, 'en').message} |"


def _routes(document: Mapping[str, Any], tag: str) -> Iterator[str]:
    for path, item in document["paths"].items():
        for method in _METHODS:
            if tag in item.get(method, {}).get("tags", ()):
                yield _route(method.upper(), path, item[method], document["components"]["schemas"])


def _route(method: str, path: str, operation: Mapping[str, Any], schemas: Mapping[str, Any]) -> str:
    codes = [*_codes(operation["responses"])]
    lines = [f"#### `{method} {path}`", "", operation["summary"]]
    if details := operation.get("description", "").replace("<br/>", "\n").strip():
        lines += ["", details]
    lines.append("")
    query = [one for one in operation.get("parameters", ()) if one["in"] == "query"]
    if query:
        lines += [f"- query: {', '.join(map(_parameter, query))}"]
    if "requestBody" in operation:
        lines += [f"- body: {_content(operation['requestBody'], schemas)}"]
    lines += [f"- answer: {_content(operation['responses']['200'], schemas)}"]
    others = [f"{status} `{code}`" for status, code in codes if code not in (*TEACHER, *WRITES)]
    others += ["those of [writing](#errors)"] if ("507", "disk_full") in codes else []
    return "\n".join([*lines, *([f"- errors: {', '.join(others)}"] if others else []), ""])


def _codes(responses: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    for status in sorted(responses):
        if status != "200":
            found = responses[status].get("description", "")
            yield from ((status, code.strip("` ")) for code in found.split(",") if "`" in code)


def _parameter(parameter: Mapping[str, Any]) -> str:
    about = parameter["schema"].get("description", "").rstrip(".")
    meaning = f" ({about})" if about else ""
    return f"`{parameter['name']}` {kind(parameter['schema'], _link)}{meaning}"


def _content(holder: Mapping[str, Any], schemas: Mapping[str, Any]) -> str:
    ((media, content),) = holder["content"].items()
    if media != "application/json":
        about = holder.get("description", "")
        return f"`{media}`" + (f". {about}" if about not in ("", "OK") else "")
    schema = content["schema"]
    fields = schemas.get(schema.get("$ref", "").rpartition("/")[2], {})
    return f"{kind(schema, _link)} {_signature(fields)}".rstrip()


def _signature(schema: Mapping[str, Any]) -> str:
    """Names of the fields, with ? for optional ones."""
    needed = schema.get("required", ())
    names = [name if name in needed else f"{name}?" for name in schema.get("properties", {})]
    return f"`{{{', '.join(names)}}}`" if names else ""


def _link(name: str) -> str:
    if name in _events():
        return "[event](events.md)"
    return f"[`{name}`](#{name.lower()})"


@cache
def _events() -> Iterable[str]:
    return ("StreamEvent", *RunEvents.model_json_schema(mode="serialization")["$defs"])


def _objects(schemas: Mapping[str, Any]) -> Iterator[str]:
    documented = {*_NOT_OBJECTS, *_events()}
    for name in sorted(schemas.keys() - documented):
        schema = schemas[name]
        if name.endswith("Event"):
            continue
        lines = [f"#### `{name}`", "", schema.get("description", ""), ""]
        if not schema.get("properties"):
            lines += [kind(schema, _link), ""]
        yield "\n".join([*lines, *field_table(schema, _link)])
