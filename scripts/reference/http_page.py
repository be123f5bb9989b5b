"""What is generated for the HTTP interface: docs/openapi.json, and the tables of docs/http-api.md."""

from pinel_desktop.messages import describe
from pinel_desktop.web.api import WRITES
from pinel_desktop.web.responses import STATUS

_ANYWHERE = (
    *("invalid_json", "key_missing", "secret_wrong", "origin_wrong", "cross_site", "not_found"),
    *("method_not_allowed", "host_wrong", "body_too_large", "internal_error"),
    *("database_newer", "database_foreign", "database_is_bundle", "database_damaged"),
    *("database_failed", "run_damaged"),
)


def errors_of_any_route() -> list[str]:
    """Rows for what every route may answer, by status."""
    return [_row(code) for code in sorted(_ANYWHERE, key=lambda code: (STATUS[code], code))]


def errors_of_writing() -> list[str]:
    """Rows for what a route that writes to the database may answer besides."""
    return [_row(code) for code in WRITES]


def _row(code: str) -> str:
    message = describe(code, {}, "en").message.replace("{{", "{").replace("}}", "}")
    return f"| {STATUS[code]} | `{code}` | {message} |"
