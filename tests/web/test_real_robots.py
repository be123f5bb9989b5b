"""Real robots over HTTP: their set-up by the teacher, and runs on them, with a fake engine."""

from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.robot.robot_profile import PROFILES
from tests.web.browser import ApiResponse, Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

PIN = "314159"
HERE = "/api/real-robots/bridge"
FAST = {"max_v_mps": 0.4, "max_omega_dps": 40.0, "room": {"width_m": 3.0, "x_m": -0.5}}


@pytest.fixture(autouse=True)
def links(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every kind of link, also kinds that this release cannot drive yet, because the engine is a fake."""
    monkeypatch.setattr("pinel_desktop.app.LINK_NAMES", ("sim", *PROFILES))


@pytest.fixture
def teacher(app: App) -> Browser:
    tab = Browser.signed_in(app.address)
    tab.put("/api/teacher/pin", {"pin": PIN})
    return tab


def set_up(teacher: Browser, **fields: Any) -> ApiResponse:
    return teacher.put(HERE, {"record": {**FAST, **fields}})


def kinds(browser: Browser) -> dict[str, dict[str, Any]]:
    return {one["link"]: one for one in browser.get("/api/real-robots").data["robots"]}


def run_request(version: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"version_id": version["id"], "world": "maze", "robot": "bridge", **more}


def test_no_robot_is_set_up_at_first_and_only_the_teacher_sets_one_up(
    browser: Browser, teacher: Browser
) -> None:
    assert {link: one["is_set_up"] for link, one in kinds(browser).items()} == dict.fromkeys(
        PROFILES, False
    )
    refused = [browser.put(HERE, {"record": {}}), browser.delete(HERE)]
    assert {one.error["code"] for one in refused} == {"teacher_only"}
    saved = set_up(teacher, port=5001)
    assert (saved.status, saved.data["is_set_up"]) == (200, True)
    assert saved.data["record"]["port"] == 5001
    assert saved.data["world"]["start"] == {"x_m": -0.5, "y_m": 0.0, "heading_deg": 0.0}
    assert (saved.data["max_v_mps"], saved.data["slow_v_mps"]) == (0.4, 0.2)
    assert kinds(browser)["dds"]["is_set_up"] is False


def test_pupils_see_the_speed_and_the_room_but_not_the_key(
    browser: Browser, teacher: Browser
) -> None:
    set_up(teacher, key="segredo")
    bridge = kinds(browser)["bridge"]
    assert (bridge["is_set_up"], bridge["max_v_mps"], bridge["record"]) == (True, 0.4, None)
    assert kinds(teacher)["bridge"]["record"]["key"] == "segredo"


def test_a_set_up_is_there_after_a_restart_and_can_be_undone(
    start_app: Callable[..., App], app: App, teacher: Browser
) -> None:
    set_up(teacher)
    app.close()
    tab = Browser.signed_in(start_app().address)
    assert kinds(tab)["bridge"]["max_v_mps"] == 0.4
    tab.post("/api/teacher/enter", {"pin": PIN})
    assert tab.delete(HERE).data["is_set_up"] is False
    assert kinds(tab)["bridge"]["record"]["max_v_mps"] == 0.3


@pytest.mark.parametrize(
    ("fields", "parts"),
    [
        ({"max_v_mps": 9}, ["“9”", "“Highest speed (m/s)”", "0.05 to 1.2"]),
        ({"max_v_mps": "x"}, ["“x”", "“Highest speed (m/s)”", "0.05 to 1.2"]),
        ({"room": {"width_m": 0.5}}, ["“0.5”", "“Width of the free floor (m)”", "1 to 50"]),
        ({"host": "a b"}, ["“a b”", "“Address of this PC”"]),
        ({"colour": "red"}, ["“red”", "“colour”"]),
        ({"room": 3}, ["“3”", "“room”"]),
        ({"room": {"x_m": 9}}, ["start"]),
    ],
)
def test_a_wrong_field_is_named_in_words_with_its_value_and_range(
    teacher: Browser, fields: dict[str, Any], parts: list[str]
) -> None:
    answer = set_up(teacher, **fields)
    assert answer.status == 422
    text = f"{answer.error['message']} {answer.error['remedy']}"
    assert [part for part in parts if part not in text] == []
    assert "Input should" not in text
    assert kinds(teacher)["bridge"]["is_set_up"] is False


def test_every_field_of_every_kind_has_a_label_and_a_hint(browser: Browser) -> None:
    for one in kinds(browser).values():
        for field in one["fields"]:
            assert not field["label"].startswith("robot_field"), field
            assert field["hint"], field
            assert (field["low"] is None) == (field["high"] is None)


def test_a_run_on_a_robot_that_is_not_set_up_or_not_known_is_refused(
    browser: Browser, group: dict[str, Any], version: dict[str, Any]
) -> None:
    answer = browser.post("/api/runs", run_request(version))
    assert (answer.status, answer.error["code"]) == (409, "robot_not_set_up")
    answer = browser.post("/api/runs", run_request(version, robot="r2d2"))
    assert (answer.status, answer.error["code"]) == (422, "unknown_link")
    assert browser.get(f"/api/groups/{group['id']}/runs").data["runs"] == []


def test_a_real_run_keeps_link_room_and_record_without_the_key(
    browser: Browser, teacher: Browser, engine: FakeEngine, app: App, version: dict[str, Any]
) -> None:
    set_up(teacher, key="segredo")
    run = browser.post(
        "/api/runs", run_request(version, start={"x_m": 1, "y_m": 1, "heading_deg": 0})
    )
    assert (run.data["link"], run.data["world"]) == ("bridge", "room")
    spec = engine.start_spec
    assert (spec["link"], spec["pace"]) == ("bridge", "live")
    assert spec["robot"]["key"] == "segredo"
    assert spec["robot"]["max_v_mps"] == 0.4
    assert spec["world"]["size_m"] == [3.0, 4.0]
    found = browser.get(f"/api/runs/{run.data['id']}").data
    assert found["world_document"]["start"]["x_m"] == -0.5
    recorded = app._store.runs.get(run.data["id"]).parameters["robot"]
    assert (recorded["link"], recorded["max_omega_dps"]) == ("bridge", 40.0)
    assert "key" not in recorded


def test_a_slow_run_has_half_of_the_speeds(
    browser: Browser, teacher: Browser, engine: FakeEngine, version: dict[str, Any]
) -> None:
    set_up(teacher)
    assert browser.post("/api/runs", run_request(version, slow=True)).status == 200
    assert (
        engine.start_spec["robot"]["max_v_mps"],
        engine.start_spec["robot"]["max_omega_dps"],
    ) == (
        0.2,
        20.0,
    )


def test_a_real_run_of_a_mission_drives_in_the_room(
    browser: Browser, teacher: Browser, engine: FakeEngine, program: dict[str, Any]
) -> None:
    set_up(teacher)
    setup = {**SETUP, "activity": "around_the_block"}
    saved = browser.post(
        f"/api/programs/{program['id']}/versions",
        {"workspace": {"blocks": {}}, "document": SQUARE, "setup": setup},
    )
    run = browser.post("/api/runs", run_request({"id": saved.data["id"]})).data
    assert (run["activity"], run["passed"], run["world"]) == ("around_the_block", None, "room")
    assert engine.start_spec["world"]["name"] == "room"


def test_a_real_run_in_a_lesson_is_of_its_activity_as_a_simulated_one(
    browser: Browser, teacher: Browser, group: dict[str, Any], version: dict[str, Any]
) -> None:
    set_up(teacher)
    classroom = teacher.post("/api/classrooms", {"name": "9º A"}).data["id"]
    moved = teacher.patch(f"/api/groups/{group['id']}", {"classroom_id": classroom})
    assert moved.status == 200, moved.data
    lesson = {"title": "Robôs", "activity": "around_the_block"}
    opened = teacher.post(f"/api/classrooms/{classroom}/lessons", lesson)
    assert opened.status == 200, opened.data
    run = browser.post("/api/runs", run_request(version)).data
    assert run["lesson_id"] == opened.data["id"]
    assert run["activity"] == "around_the_block"


def test_what_no_real_robot_senses_is_a_fault_of_its_block_before_the_run(
    browser: Browser, teacher: Browser, group: dict[str, Any], program: dict[str, Any]
) -> None:
    set_up(teacher)
    red = {"op": "==", "args": [{"sensor": "floor"}, "red"]}
    commands = [
        {"action": "wait_until", "block": "w", "condition": red},
        {"action": "go_to_place", "block": "p", "place": "A"},
        {"action": "move_forward", "block": "m", "distance": 1},
    ]
    saved = browser.post(
        f"/api/programs/{program['id']}/versions",
        {"workspace": {"blocks": {}}, "document": {**SQUARE, "commands": commands}},
    )
    assert saved.data["faults"] == []
    answer = browser.post("/api/runs", run_request(saved.data))
    assert (answer.status, answer.error["code"]) == (422, "invalid_program")
    found = [(one["block"], one["code"], one["pointer"]) for one in answer.error["faults"]]
    assert found == [
        ("w", "sensor_missing", "/commands/0/condition/args/0"),
        ("p", "places_missing", "/commands/1"),
    ]
    assert "“floor”" in answer.error["faults"][0]["message"]
    assert browser.get(f"/api/groups/{group['id']}/runs").data["runs"] == []
    assert browser.post("/api/runs", run_request(saved.data, robot="sim")).status == 200


SETUP: dict[str, Any] = {
    "preset": "ideal",
    "feedback": "pose",
    "world": "empty_room",
    "start": None,
    "speed": 1,
    "activity": None,
    "n_hints": 0,
}


def test_only_the_teacher_tries_the_connection_and_hears_what_the_robot_tells(
    browser: Browser, teacher: Browser
) -> None:
    assert browser.post(f"{HERE}/contact").error["code"] == "teacher_only"
    assert teacher.post(f"{HERE}/contact").error["code"] == "robot_not_set_up"
    set_up(teacher)
    found = teacher.post(f"{HERE}/contact").data
    assert (found["x_m"], found["rate_hz"], found["problem"]) == (1.0, 30.0, None)


def test_a_robot_that_cannot_be_reached_is_told_in_words(teacher: Browser) -> None:
    teacher.put("/api/real-robots/dds", {"record": {}})
    found = teacher.post("/api/real-robots/dds/contact").data
    assert "/cmd_vel" in found["remedy"]
    assert found["remedy"]
    assert found["rate_hz"] is None


def test_only_the_teacher_finds_robots_moves_one_by_keys_and_says_where_it_stands(
    browser: Browser, teacher: Browser, engine: FakeEngine
) -> None:
    set_up(teacher)
    asked = {
        "find": {"record": {}},
        "jog": {"drive": 1, "turn": 0, "sent_ms": 5000},
        "at-start": {},
    }
    for path, body in asked.items():
        assert browser.post(f"{HERE}/{path}", body).error["code"] == "teacher_only"
    assert engine.of_robots == []
    for path in ("jog", "at-start"):
        assert teacher.post(f"{HERE}/{path}", asked[path]).status == 200
    assert browser.delete(f"{HERE}/jog").status == 200  # everybody may stop it
    assert engine.of_robots == [
        ("jog", "bridge", 1.0, 0.0, 5.0),
        ("at_start", "bridge"),
        ("halt", "bridge"),
    ]


def test_robots_are_looked_for_in_the_domain_of_a_form_that_is_not_saved(teacher: Browser) -> None:
    found = teacher.post("/api/real-robots/dds/find", {"record": {"domain": 7}}).data
    assert found["domain"] == 7
    assert [(one["namespace"], one["holder"]) for one in found["robots"]] == [("r1", "LAB-03")]
    assert teacher.post(f"{HERE}/find", {"record": {}}).error["code"] == "unknown_link"
    wrong = teacher.post("/api/real-robots/dds/find", {"record": {"domain": 999}})
    assert "999" in wrong.error["message"]


def test_a_page_that_watches_is_told_how_the_robot_is_in_words(
    browser: Browser, teacher: Browser, engine: FakeEngine, app: App
) -> None:
    assert browser.post(f"{HERE}/watch", {"is_first": True}).error["code"] == "robot_not_set_up"
    set_up(teacher)
    assert browser.post(f"{HERE}/watch", {"is_first": True}).status == 200
    engine.on_robot(STATE)
    with app._hub.subscribe() as subscription:
        browser.post(f"{HERE}/watch", {"is_first": False})
        assert subscription.get(timeout_s=0.0) is None
        browser.post(f"{HERE}/watch", {"is_first": True})  # a second page gets the known state
        event = subscription.get(timeout_s=0.0)
    assert event is not None
    assert (event["type"], event["state"], event["code"]) == (
        "robot_state",
        "searching",
        "robot_held",
    )
    assert "LAB-03" in event["message"]
    assert event["remedy"]
    assert engine.of_robots == [("watch", "bridge")] * 3


STATE: dict[str, Any] = {
    "type": "robot_state",
    "link": "bridge",
    "use": "watch",
    "state": "searching",
    "address": "127.0.0.1:5000",
    **dict.fromkeys(("age_s", "rate_hz", "battery", "x_m", "y_m", "heading_deg", "holder")),
    "code": "robot_held",
    "params": {"holder": "LAB-03", "topic": "/cmd_vel"},
}
