"""Every error response has the same JSON shape with a message, whatever raised the error."""

from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.web.responses import STATUS
from storage import StoreError
from tests.web.browser import ApiResponse, Browser
from tests.web.fake_engine import FakeEngine

NOWHERE = "01935000-0000-7000-8000-000000000000"


def check_shape(answer: ApiResponse, status: int, code: str) -> dict[str, Any]:
    assert answer.status == status, answer.body
    assert answer.headers["Content-Type"] == "application/json"
    assert set(answer.data) == {"error"}
    error = answer.error
    assert set(error) == {"code", "message", "remedy", "details", "params", "faults"}
    assert error["code"] == code
    assert error["message"]
    assert error["message"] != code
    assert error["remedy"]
    assert "{" not in error["message"] + error["remedy"]
    return error


@pytest.mark.parametrize(
    ("method", "path", "data", "status", "code"),
    [
        ("GET", "/api/nothing", None, 404, "not_found"),
        ("POST", "/api/nothing", {}, 404, "not_found"),
        ("DELETE", "/api/groups", None, 405, "method_not_allowed"),
        ("POST", "/api/status", {}, 405, "method_not_allowed"),
        ("PUT", "/api/settings", {"language": "xx"}, 422, "invalid_request"),
        ("POST", "/api/groups", {"nome": "A"}, 422, "invalid_request"),
        ("POST", "/api/groups", {"name": 7}, 422, "invalid_request"),
        ("POST", "/api/groups", ["A"], 422, "invalid_request"),
        ("POST", "/api/groups", "A", 422, "invalid_request"),
        ("POST", "/api/groups", None, 422, "invalid_request"),
        ("POST", "/api/groups", {"name": "  "}, 422, "name_empty"),
        ("POST", "/api/groups", {"name": "x" * 61}, 422, "name_too_long"),
        ("GET", f"/api/groups/{NOWHERE}/programs", None, 404, "group_not_found"),
        ("POST", f"/api/groups/{NOWHERE}/programs", {"name": "A"}, 404, "group_not_found"),
        ("GET", f"/api/groups/{NOWHERE}/runs", None, 404, "group_not_found"),
        ("GET", f"/api/groups/{NOWHERE}/runs?limit=0", None, 422, "invalid_request"),
        ("GET", f"/api/groups/{NOWHERE}/runs?limit=many", None, 422, "invalid_request"),
        ("GET", f"/api/programs/{NOWHERE}", None, 404, "program_not_found"),
        ("PATCH", f"/api/programs/{NOWHERE}", {"name": "A"}, 404, "program_not_found"),
        (
            "POST",
            f"/api/programs/{NOWHERE}/versions",
            {"workspace": {}, "document": None},
            404,
            "program_not_found",
        ),
        ("POST", "/api/check", {"document": 7}, 422, "invalid_request"),
        ("POST", "/api/runs", {"version_id": NOWHERE, "world": "x"}, 404, "version_not_found"),
        (
            "POST",
            "/api/runs",
            {"version_id": NOWHERE, "world": "x", "seed": -1},
            422,
            "invalid_request",
        ),
        ("GET", f"/api/runs/{NOWHERE}", None, 404, "run_not_found"),
        ("GET", f"/api/runs/{NOWHERE}/events", None, 404, "run_not_found"),
        ("GET", f"/api/runs/{NOWHERE}/telemetry", None, 404, "run_not_found"),
        ("POST", f"/api/runs/{NOWHERE}/commands", {"do": "stop"}, 404, "run_not_found"),
    ],
)
def test_every_family_of_routes_answers_errors_in_the_one_shape(
    browser: Browser, method: str, path: str, data: Any, status: int, code: str
) -> None:
    check_shape(browser.send(method, path, data), status, code)


@pytest.mark.parametrize(
    ("method", "path", "data", "parts"),
    [
        ("POST", "/api/groups", {"name": 7}, ["“name”", "um texto"]),
        ("POST", "/api/groups", {}, ["Falta “name”"]),
        ("POST", "/api/groups", {"name": "A", "cor": 1}, ["“cor”", "não existe"]),
        ("POST", "/api/groups", {"name": "A", "\ud800": 1}, ["objeto JSON"]),
        ("POST", "/api/groups", {"name": "\ud800"}, ["“name”", "um texto"]),
        ("POST", "/api/groups", {"name": "x" * 1001}, ["“name”", "1000 caracteres"]),
        ("POST", "/api/groups", [], ["objeto JSON"]),
        ("POST", "/api/check", {"document": 7}, ["“document”", "objeto", "lista"]),
        ("PUT", "/api/settings", {"language": "xx"}, ["“language”", ", ".join(LANGUAGES)]),
        ("GET", f"/api/groups/{NOWHERE}/runs?limit=0", None, ["“limit”", "de 1 a 200"]),
        ("GET", f"/api/groups/{NOWHERE}/runs?limit=201", None, ["“limit”", "de 1 a 200"]),
        ("GET", f"/api/groups/{NOWHERE}/runs?limit=x", None, ["inteiro", "de 1 a 200"]),
        (
            "POST",
            "/api/runs",
            {"version_id": "v", "world": "w", "seed": -1},
            ["“seed”", "de 0 a 9007"],
        ),
    ],
    ids=ascii,
)
def test_a_value_that_does_not_fit_is_named_and_what_fits_is_told_in_words(
    browser: Browser, method: str, path: str, data: Any, parts: list[str]
) -> None:
    browser.send("PUT", "/api/settings", {"language": "pt-BR"})
    error = check_shape(browser.send(method, path, data), 422, "invalid_request")
    text = f"{error['message']} {error['remedy']}"
    assert [part for part in parts if part not in text] == []
    assert "_" not in text
    assert "dict" not in text


@pytest.mark.parametrize(
    "body",
    [b"{", b"\xff\xfe", b'{"name": NaN}', b'{"name": 1e999}', b"[" * 100_000, b'{"name": "A"'],
)
def test_a_body_that_is_no_json_is_told_as_that(browser: Browser, body: bytes) -> None:
    answer = browser.send(
        "POST", "/api/groups", body=body, headers={"Content-Type": "application/json"}
    )
    check_shape(answer, 400, "invalid_json")


def test_a_form_is_not_taken_for_json(browser: Browser) -> None:
    answer = browser.send(
        "POST", "/api/groups", body=b'{"name": "A"}', headers={"Content-Type": "text/plain"}
    )
    check_shape(answer, 400, "invalid_json")


def test_a_body_beyond_4_mib_is_refused_in_words(browser: Browser, program: dict[str, Any]) -> None:
    path = f"/api/programs/{program['id']}/versions"
    answer = browser.post(path, {"workspace": {"x": "y" * 2**22}, "document": None})
    assert "4 MiB" in check_shape(answer, 413, "body_too_large")["message"]
    assert browser.post(path, {"workspace": {"x": "y" * 2**21}, "document": None}).status == 200


@pytest.mark.parametrize(
    "code",
    ["disk_full", "database_read_only", "database_locked", "database_damaged", "database_failed"],
)
def test_an_error_of_the_store_keeps_its_words(
    app: App, browser: Browser, monkeypatch: pytest.MonkeyPatch, code: str
) -> None:
    def fail(name: str, **_more: object) -> None:
        raise StoreError(code, path="/disk/pinel.db", problem="I/O")

    monkeypatch.setattr(app._store.groups, "create", fail)
    check_shape(browser.post("/api/groups", {"name": "A"}), STATUS[code], code)


def test_what_nobody_foresaw_is_an_error_in_words_that_gives_nothing_away(
    app: App, browser: Browser, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail() -> None:
        raise ZeroDivisionError("a secret")

    monkeypatch.setattr(app._store.groups, "all", fail)
    answer = browser.get("/api/groups")
    check_shape(answer, 500, "internal_error")
    assert "secret" not in answer.text
    assert "a secret" in caplog.text


def test_errors_speak_the_language_that_was_chosen(browser: Browser) -> None:
    def message() -> str:
        return str(browser.get("/api/nothing").error["message"])

    english = message()
    assert browser.send("PUT", "/api/settings", {"language": "pt-BR"}).data == {"language": "pt-BR"}
    portuguese = message()
    browser.send("PUT", "/api/settings", {"language": "es"})
    assert len({english, portuguese, message()}) == 3


def test_an_engine_that_is_not_ready_begins_nothing_and_leaves_nothing(
    browser: Browser, engine: FakeEngine, group: dict[str, Any], version: dict[str, Any]
) -> None:
    engine.state = "starting"
    answer = browser.post("/api/runs", {"version_id": version["id"], "world": "empty_room"})
    check_shape(answer, 503, "engine_not_ready")
    assert browser.get(f"/api/groups/{group['id']}/runs").data == {"runs": [], "next": None}
