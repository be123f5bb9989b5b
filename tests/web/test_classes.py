"""Classes, lessons, the teacher's sign-in, the bin and notes over HTTP."""

from typing import Any

import pytest

from pinel_desktop.app import App
from tests.web.browser import Browser
from tests.web.conftest import SQUARE

PIN = "314159"


@pytest.fixture
def teacher(app: App) -> Browser:
    """Another browser, in which the teacher has set the first PIN."""
    tab = Browser.signed_in(app.address)
    assert tab.put("/api/teacher/pin", {"pin": PIN}).data == {"has_pin": True, "is_open": True}
    return tab


@pytest.fixture
def ninth(teacher: Browser) -> Any:
    return teacher.post("/api/classrooms", {"name": "9º A"}).data


def test_the_door_opens_with_the_pin_only(browser: Browser, teacher: Browser) -> None:
    assert browser.get("/api/teacher").data == {"has_pin": True, "is_open": False}
    refused = browser.post("/api/classrooms", {"name": "9º A"})
    assert (refused.status, refused.error["code"]) == (403, "teacher_only")
    assert browser.put("/api/teacher/pin", {"pin": "2718"}).error["code"] == "teacher_only"
    assert browser.post("/api/teacher/enter", {"pin": "0000"}).error["code"] == "pin_wrong"
    assert browser.post("/api/teacher/enter", {"pin": PIN}).data["is_open"] is True
    assert browser.post("/api/classrooms", {"name": "9º A"}).status == 200
    assert browser.post("/api/teacher/leave").data["is_open"] is False
    assert browser.post("/api/classrooms", {"name": "9º B"}).status == 403
    assert teacher.get("/api/teacher").data["is_open"] is True


def test_without_a_pin_the_door_asks_for_one(browser: Browser) -> None:
    assert browser.get("/api/teacher").data == {"has_pin": False, "is_open": False}
    assert browser.post("/api/classrooms", {"name": "A"}).error["code"] == "pin_missing"
    for pin in ("123", "12345a", "1" * 13, "１２３４", ""):
        refused = browser.put("/api/teacher/pin", {"pin": pin})
        assert (refused.status, refused.error["code"]) == (422, "pin_format")


def test_guessing_the_pin_takes_longer_and_longer(browser: Browser, teacher: Browser) -> None:
    for _ in range(5):
        assert browser.post("/api/teacher/enter", {"pin": "0000"}).error["code"] == "pin_wrong"
    refused = browser.post("/api/teacher/enter", {"pin": PIN})
    assert (refused.status, refused.error["code"]) == (429, "pin_wait")
    assert 0 < refused.error["params"]["seconds"] <= 30
    assert teacher.get("/api/teacher").data["is_open"] is True


def test_a_group_is_made_in_a_class_with_a_picture(
    browser: Browser, teacher: Browser, ninth: dict[str, Any]
) -> None:
    new_group = {"name": "Os Robôs", "classroom_id": ninth["id"], "picture": "rocket"}
    group = browser.post("/api/groups", new_group).data
    assert (group["picture"], group["classroom_id"]) == ("rocket", ninth["id"])
    assert browser.get("/api/classrooms").data["classrooms"][0]["n_groups"] == 1
    place = f"/api/groups/{group['id']}"
    assert browser.patch(place, {"picture": "cat", "name": "Gatos"}).data["name"] == "Gatos"
    assert browser.patch(place, {"picture": "x"}).error["code"] == "picture_unknown"
    assert browser.patch(place, {"robot_pattern": "x"}).error["code"] == "pattern_unknown"
    robot = {"robot_name": "Faísca", "robot_pattern": "dots"}
    assert browser.patch(place, robot).data.items() >= robot.items()
    assert browser.patch(place, {"classroom_id": ninth["id"]}).error["code"] == "teacher_only"
    other = teacher.post("/api/classrooms", {"name": "9º B"}).data
    moved = teacher.patch(place, {"classroom_id": other["id"]}).data
    assert moved["classroom_id"] == other["id"]
    unknown = browser.post("/api/groups", {"name": "C", "classroom_id": "x"})
    assert unknown.error["code"] == "classroom_not_found"


def test_a_lesson_is_opened_changed_joined_and_closed(
    browser: Browser, teacher: Browser, ninth: dict[str, Any]
) -> None:
    here = f"/api/classrooms/{ninth['id']}"
    assert browser.get(f"{here}/lesson").data["lesson"] is None
    assert browser.post(f"{here}/lessons", {"title": "Aula 1"}).error["code"] == "teacher_only"
    lesson = teacher.post(f"{here}/lessons", {"title": "Aula 1", "activity": "square"}).data
    assert browser.get(f"{here}/lesson").data["lesson"]["id"] == lesson["id"]
    second = teacher.post(f"{here}/lessons", {"title": "Aula 2"}).data
    place = f"/api/lessons/{lesson['id']}"
    assert teacher.patch(place, {"part_of": second["id"]}).data["part_of"] == second["id"]
    changed = teacher.patch(place, {"part_of": "", "activity": "", "title": "Aula um"}).data
    assert (changed["part_of"], changed["activity"], changed["title"]) == (None, None, "Aula um")
    assert teacher.patch(place, {"title": ""}).data["title"] == ""
    assert teacher.patch(place, {"title": "Aula um"}).data["title"] == "Aula um"
    closed = teacher.patch(f"/api/lessons/{second['id']}", {"closed": True}).data
    assert closed["closed_at"] is not None
    listed = teacher.get(f"{here}/lessons").data["lessons"]
    assert {one["title"] for one in listed} == {"Aula um", "Aula 2"}
    for name in ("../../etc/passwd.json", "no-such"):
        refused = teacher.post(f"{here}/lessons", {"title": "A", "activity": name})
        assert refused.error["code"] == "unknown_activity"


def test_activities_have_titles_in_the_page_s_language(browser: Browser) -> None:
    assert activities(browser)["square"]["title"] == "A square of 1 m"
    browser.put("/api/settings", {"language": "pt-BR"})
    assert activities(browser)["square"]["title"] == "Um quadrado de 1 m"


def test_activities_have_a_picture_of_their_goal(browser: Browser) -> None:
    pictures = {name: one["goal_picture"] for name, one in activities(browser).items()}
    assert pictures["maze"]["world"]["name"] == "maze"
    assert pictures["maze"]["zones"] == ["meta"]
    assert pictures["maze"]["lines"] == []  # the pupils search for the path themselves
    assert [line["sign"] for line in pictures["b_or_a"]["lines"]] == ["B", "A"]
    assert pictures["square"]["lines"][0]["points"][1] == [1.0, 0.0]
    assert pictures["pushing"]["boxes"] == {"0": [2.87, 0.0, 0.0]}


def activities(browser: Browser) -> dict[str, Any]:
    return {one["name"]: one for one in browser.get("/api/activities").data["activities"]}


def test_a_program_goes_into_the_bin_and_comes_back(
    browser: Browser, group: dict[str, Any], program: dict[str, Any]
) -> None:
    thrown = browser.delete(f"/api/programs/{program['id']}").data
    assert thrown["deleted_at"] is not None
    place = f"/api/groups/{group['id']}"
    assert browser.get(f"{place}/programs").data["programs"] == []
    assert [one["id"] for one in browser.get(f"{place}/bin").data["programs"]] == [program["id"]]
    assert browser.post(f"/api/programs/{program['id']}/take-back").data["deleted_at"] is None
    assert browser.get(f"{place}/bin").data["programs"] == []


def test_the_line_of_versions_and_their_names(browser: Browser, program: dict[str, Any]) -> None:
    place = f"/api/programs/{program['id']}/versions"
    ids = [
        browser.post(place, {"workspace": {"n": n}, "document": SQUARE}).data["id"]
        for n in range(3)
    ]
    back = {"workspace": {"n": 0}, "document": None, "parent_id": ids[0]}
    browser.post(place, back)
    assert browser.put(f"/api/versions/{ids[0]}/label", {"text": "anda"}).data == {}
    line = browser.get(place).data
    assert [mark["number"] for mark in line["versions"]] == [4, 3, 2, 1]
    assert (line["versions"][0]["parent_id"], line["versions"][0]["can_run"]) == (ids[0], False)
    assert line["versions"][-1]["label"] == "anda"
    page = browser.get(f"{place}?limit=2").data
    rest = browser.get(f"{place}?limit=2&before={page['next']}").data
    assert [mark["number"] for mark in rest["versions"]] == [2, 1]


def test_the_group_finds_the_teacher_s_note(
    browser: Browser, teacher: Browser, group: dict[str, Any], run: dict[str, Any]
) -> None:
    place = f"/api/runs/{run['id']}/notes"
    assert browser.post(place, {"text": "oi"}).error["code"] == "teacher_only"
    note = teacher.post(place, {"text": "Por que 90°?"}).data
    mine = f"/api/groups/{group['id']}/notes?unseen=true"
    assert [one["text"] for one in browser.get(mine).data["notes"]] == ["Por que 90°?"]
    assert browser.post(f"/api/notes/{note['id']}/seen").data["seen_at"] is not None
    assert browser.get(mine).data["notes"] == []
    assert teacher.patch(f"/api/notes/{note['id']}", {"text": "E agora?"}).data["seen_at"] is None
    assert [one["text"] for one in browser.get(place).data["notes"]] == ["E agora?"]


def test_this_pc_has_a_name_that_the_teacher_chooses(browser: Browser, teacher: Browser) -> None:
    assert browser.patch("/api/computer", {"name": "PC 7"}).error["code"] == "teacher_only"
    assert teacher.patch("/api/computer", {"name": "PC 7"}).data["name"] == "PC 7"
    assert browser.get("/api/computer").data["name"] == "PC 7"


def test_examples_are_in_the_page_s_language_with_a_program_and_a_picture(browser: Browser) -> None:
    game = examples(browser)["guessing_game"]
    assert (game["title"], game["world"]) == ("Guess", "empty_room")
    assert game["document"]["name"] == "Guess"
    assert game["document"]["commands"][0]["name"] == "secret"
    assert game["picture"]["lines"][0]["points"] == [[0.0, 0.0], [0.5, 0.0]]
    browser.put("/api/settings", {"language": "pt-BR"})
    assert examples(browser)["guessing_game"]["document"]["commands"][0]["name"] == "segredo"


def examples(browser: Browser) -> dict[str, Any]:
    return {one["name"]: one for one in browser.get("/api/examples").data["examples"]}
