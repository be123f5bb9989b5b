"""The OpenAPI description: complete, and consistent with the responses."""

import json
import re
from copy import deepcopy
from typing import Any

import pytest
import schemathesis
from flask import Flask
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis.checks import not_a_server_error
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from pinel_desktop.app import App
from pinel_desktop.messages import catalogue
from pinel_desktop.web.description import description, description_text
from pinel_desktop.web.routes import RESOURCES
from storage import Store
from tests.web.browser import Browser

STREAM = "/api/stream"
CHECKS = (
    not_a_server_error,
    status_code_conformance,
    response_schema_conformance,
    content_type_conformance,
)
FEW = settings(
    max_examples=2,
    deadline=None,
    database=None,
    derandomize=True,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)


@pytest.fixture(scope="module")
def document() -> dict[str, Any]:
    return description()


@pytest.fixture(scope="module")
def operations(document: dict[str, Any]) -> list[dict[str, Any]]:
    return [operation for path in document["paths"].values() for operation in path.values()]


def test_the_app_answers_with_its_own_description(browser: Browser) -> None:
    assert browser.get("/api/openapi.json").data == json.loads(description_text())


def test_every_route_is_described_with_all_its_methods(document: dict[str, Any]) -> None:
    every = Flask(__name__)
    for module in RESOURCES:
        every.register_blueprint(module.api)
    routes = {
        (rule.rule.replace("<", "{").replace(">", "}"), method.lower())
        for rule in every.url_map.iter_rules()
        for method in (rule.methods or set()) - {"HEAD", "OPTIONS"}
        if rule.rule.startswith("/api/")
    }
    described = document["paths"]
    assert {(path, method) for path, item in described.items() for method in item} == routes


def test_every_operation_has_a_readable_name_of_its_own(operations: list[dict[str, Any]]) -> None:
    names = [operation["operationId"] for operation in operations]
    assert len(set(names)) == len(names)
    assert all(name.isalpha() and name[0].islower() for name in names)


def test_every_operation_says_what_it_does_and_how_it_fails(
    operations: list[dict[str, Any]],
) -> None:
    for operation in operations:
        assert operation["summary"].endswith(".")
        for status, answer in operation["responses"].items():
            if status != "200":
                schema = answer["content"]["application/json"]["schema"]
                assert schema == {"$ref": "#/components/schemas/ErrorAnswer"}


def test_a_route_that_wants_the_teacher_says_so(operations: list[dict[str, Any]]) -> None:
    for operation in operations:
        is_teacher_only = "`teacher_only`" in operation["responses"]["403"].get("description", "")
        assert is_teacher_only == ("or the teacher." in operation["summary"]), operation[
            "operationId"
        ]


def test_every_error_that_a_route_names_has_words(operations: list[dict[str, Any]]) -> None:
    for operation in operations:
        for answer in operation["responses"].values():
            for code in re.findall(r"`(\w+)`", answer.get("description", "")):
                assert code in catalogue("en"), code


def test_every_reference_leads_to_a_schema(document: dict[str, Any]) -> None:
    referenced = {
        part.split('"')[0] for part in json.dumps(document).split("#/components/schemas/")[1:]
    }
    assert referenced <= set(document["components"]["schemas"])


def an_activity(store: Store) -> str:
    key = store.own_activities.new_key()
    goal: dict[str, object] = {"lines": [], "zones": [], "boxes": {}}
    store.own_activities.save(key, "Até a porta", {"pinel_activity": 3, "name": key}, goal)
    return key


@pytest.mark.parametrize("ids", ["made up", "real"])
def test_what_hypothesis_makes_up_is_answered_as_described(
    app: App, browser: Browser, document: dict[str, Any], ids: str, run: dict[str, Any]
) -> None:
    """A few dozen made-up requests: none may end in a 500, or in an answer that is not described."""
    document = deepcopy(document)  # which Schemathesis changes
    del document["paths"][STREAM]  # the stream never ends
    base_url = f"http://{browser.host}:{browser.port}"
    browser.put("/api/teacher/pin", {"pin": "314159"})  # for routes of the teacher
    store = app._store
    classroom = store.classrooms.create("9º A").id
    real = {
        "groups": run["group_id"],
        "programs": run["program_id"],
        "versions": run["version_id"],
        "runs": run["id"],
        "classrooms": classroom,
        "lessons": store.lessons.open(classroom, "Aula 1").id,
        "notes": store.notes.write(run["id"], "Oi").id,
        "own-activities": an_activity(store),
        "calibrated-robots": store.calibrated_robots.create("Pioneer", "pioneer_3dx", {}, {}).id,
    }

    def check(case: Any) -> None:
        deletes_real = case.method == "DELETE" and not case.path.startswith("/api/programs/")
        if ids == "real" and "id" in case.path_parameters and not deletes_real:
            case.path_parameters["id"] = real[case.path.split("/")[2]]
        response = case.call(base_url=base_url, headers=browser.headers)
        case.validate_response(response, checks=CHECKS)

    found: Any
    for found in schemathesis.openapi.from_dict(document).get_all_operations():
        operation = found.ok()
        assert operation is not None
        generated: Any = given(operation.as_strategy())
        FEW(generated(check))()
