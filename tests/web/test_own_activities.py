"""Own activities over HTTP: the form, the trial, the lists, and runs that an own activity judges."""

from typing import Any

import pytest

from pinel_desktop.app import App
from tests.storage.sample_runs import ended
from tests.web.browser import Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

PIN = "314159"
MOVE: dict[str, Any] = {
    **SQUARE,
    "commands": [{"action": "move_forward", "block": "m", "distance": 2}],
}
DRAFT: dict[str, Any] = {
    "title": "Até a linha",
    "story": "Andem dois metros.",
    "criteria": "Vale: parar a 2 m da partida.",
    "hints": ["Contem os quadros.", ""],
    "question": "Quanto faltou?",
    "level": 1,
    "minutes": 5,
    "world": "empty_room",
    "solution": MOVE,
    "checks": [{"check": "ends_at", "x_m": 2.0, "y_m": 0.0, "within_m": 0.1}],
}


@pytest.fixture
def teacher(app: App) -> Browser:
    tab = Browser.signed_in(app.address)
    tab.put("/api/teacher/pin", {"pin": PIN})
    return tab


@pytest.fixture
def made(teacher: Browser) -> str:
    """The key of a stored activity."""
    answer = teacher.post("/api/own-activities", DRAFT)
    assert answer.status == 200, answer.data
    return str(answer.data["id"])


def test_only_the_teacher_makes_activities(browser: Browser, teacher: Browser, made: str) -> None:
    here = f"/api/own-activities/{made}"
    refused = [
        browser.get("/api/own-activities"),
        browser.get(here),
        browser.post("/api/own-activities", DRAFT),
        browser.put(here, DRAFT),
        browser.delete(here),
        browser.post(f"{here}/take-back"),
        browser.post("/api/own-activities/try", DRAFT),
        browser.post("/api/own-activities/measure", {"world": "maze", "solution": MOVE}),
    ]
    assert {one.error["code"] for one in refused} == {"teacher_only"}


def test_checks_that_fit_a_solution_are_proposed(teacher: Browser) -> None:
    stage = {"world": "neighbourhood", "solution": {**MOVE, "commands": 2 * MOVE["commands"]}}
    found = teacher.post("/api/own-activities/measure", stage).data
    proposal = found["proposal"]
    checks = {check.pop("check"): check for check in proposal["checks"]}
    assert found["faults"] == []
    assert proposal["finished"]
    assert "escola" in proposal["zones"]
    assert checks["ends_at"]["x_m"] == pytest.approx(4.0, abs=0.02)
    assert checks["block_count"] == {"at_most": 2}
    assert checks["visits"]["zones"][0] == "casa"
    assert checks["draws"]["template"][0][0] == [0.0, 0.0]
    assert not checks.keys() & {"closed", "says", "mark_count", "nesting"}


def test_a_solution_with_faults_and_an_unknown_world_are_told(teacher: Browser) -> None:
    wrong = {**MOVE, "commands": [{"action": "fly"}]}
    for stage in ({"world": "empty_room", "solution": wrong}, {"world": "x", "solution": MOVE}):
        found = teacher.post("/api/own-activities/measure", stage).data
        assert found["proposal"] is None
        assert found["faults"][0]["message"]


def test_the_trial_tells_the_solution_from_an_empty_program_under_both_robots(
    teacher: Browser,
) -> None:
    found = teacher.post("/api/own-activities/try", DRAFT).data["trials"]
    assert [(one["program"], one["preset"], one["passed"]) for one in found] == [
        ("solution", "ideal", True),
        ("empty", "ideal", False),
        ("solution", "realistic", True),
        ("empty", "realistic", False),
    ]
    assert all(one["is_right"] for one in found)
    assert "2 m" in found[1]["words"]


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"checks": []}, "own_activity_unsound"),  # an empty program finishes too
        ({"checks": [{"check": "time", "at_most_s": 1}]}, "own_activity_unsound"),
        ({"checks": [{"check": "ends_in", "zone": "praça"}]}, "invalid_activity"),
        ({"checks": [{"check": "dances"}]}, "invalid_activity"),
        ({"world": "a world of tomorrow"}, "invalid_activity"),
        ({"solution": {**MOVE, "commands": [{"action": "fly"}]}}, "invalid_activity"),
        ({"title": " "}, "name_empty"),
        ({"title": "x" * 61}, "name_too_long"),
    ],
)
def test_what_no_group_could_solve_is_not_kept(
    teacher: Browser, changes: dict[str, Any], code: str
) -> None:
    refused = teacher.post("/api/own-activities", {**DRAFT, **changes})
    assert (refused.status, refused.error["code"]) == (422, code)
    assert teacher.get("/api/own-activities").data["activities"] == []


def test_it_is_edited_deleted_and_brought_back(teacher: Browser, made: str) -> None:
    here = f"/api/own-activities/{made}"
    shown = teacher.get(here).data
    assert shown["hints"] == ["Contem os quadros."]
    assert shown["checks"] == DRAFT["checks"]
    assert teacher.put(here, {**DRAFT, "title": "Até a parede"}).data["id"] == made
    (listed,) = teacher.get("/api/own-activities").data["activities"]
    assert (listed["title"], listed["problem"]) == ("Até a parede", None)
    assert listed["goal_picture"]["lines"][0]["points"][-1][0] == pytest.approx(-2.0, abs=9)
    teacher.delete(here)
    assert teacher.get("/api/own-activities").data["activities"] == []
    teacher.post(f"{here}/take-back")
    assert len(teacher.get("/api/own-activities").data["activities"]) == 1
    assert teacher.put("/api/own-activities/x", DRAFT).error["code"] == "own_activity_not_found"


def test_groups_and_lessons_choose_it_like_any_other(
    browser: Browser, teacher: Browser, made: str
) -> None:
    offered = browser.get("/api/activities").data["activities"]
    assert [one["name"] for one in offered if one["own"]] == [made]
    card = browser.get(f"/api/activities/{made}").data
    assert (card["title"], card["criteria"], card["next"]) == (
        "Até a linha",
        "Vale: parar a 2 m da partida.",
        None,
    )
    classroom = teacher.post("/api/classrooms", {"name": "9º A"}).data["id"]
    new = {"title": "", "activity": made}
    lesson = teacher.post(f"/api/classrooms/{classroom}/lessons", new).data
    assert (lesson["title"], lesson["activity"]) == ("Até a linha", made)
    nameless = teacher.post(f"/api/classrooms/{classroom}/lessons", {"title": " "})
    assert nameless.error["code"] == "name_empty"
    group = browser.post("/api/groups", {"name": "G", "classroom_id": classroom}).data["id"]
    program = browser.post(f"/api/groups/{group}/activities", {"activity": made}).data
    assert program["name"] == "Até a linha"
    assert teacher.get(f"/api/lessons/{lesson['id']}/review").status == 200


def test_a_run_is_judged_by_it_also_after_it_was_deleted(
    app: App, browser: Browser, teacher: Browser, engine: FakeEngine, made: str
) -> None:
    classroom = teacher.post("/api/classrooms", {"name": "9º A"}).data["id"]
    group = browser.post("/api/groups", {"name": "G", "classroom_id": classroom}).data["id"]
    program = browser.post(f"/api/groups/{group}/activities", {"activity": made}).data["id"]
    setup = browser.get(f"/api/programs/{program}").data["version"]["setup"]
    assert setup["activity"] == made
    passed = []
    with browser.stream() as events:
        for i, document in enumerate(({**MOVE, "commands": []}, MOVE)):
            version = {"workspace": {"n": i}, "document": document, "setup": setup}
            saved = browser.post(f"/api/programs/{program}/versions", version).data["id"]
            run = browser.post("/api/runs", {"version_id": saved, "world": "maze"}).data
            assert (run["activity"], run["world"]) == (made, "empty_room")
            engine.send(ended(run["id"], 0, 0))
            passed.append(events.until("judged")[-1]["passed"])
            teacher.delete(f"/api/own-activities/{made}")
    assert passed == [False, True]
    tried = browser.get(f"/api/groups/{group}/activities").data["activities"]
    assert tried == [{"name": made, "passed": True}]


def test_joined_lessons_with_different_activities_are_told(teacher: Browser, made: str) -> None:
    classroom = teacher.post("/api/classrooms", {"name": "9º A"}).data["id"]
    here = f"/api/classrooms/{classroom}/lessons"
    first, second = (
        teacher.post(here, {"title": "", "activity": name}).data["id"] for name in (made, "square")
    )

    def differing() -> list[str]:
        review = teacher.get(f"/api/lessons/{first}/review").data
        return list(review["summary"]["differing"])

    assert differing() == []
    teacher.patch(f"/api/lessons/{second}", {"part_of": first})
    assert sorted(differing()) == ["A square of 1 m", "Até a linha"]


def test_one_of_a_newer_release_is_told_and_offered_to_nobody(
    app: App, browser: Browser, teacher: Browser
) -> None:
    store = app._store
    goal: dict[str, Any] = {"lines": [], "zones": [], "boxes": {}}
    newer, broken = store.own_activities.new_key(), store.own_activities.new_key()
    store.own_activities.save(newer, "De amanhã", {"pinel_activity": 3, "name": newer}, goal)
    store.own_activities.save(broken, "Mexida", {"pinel_activity": 2, "checks": 7}, {"lines": 1})
    listed = teacher.get("/api/own-activities").data["activities"]
    assert [one["problem"]["code"] for one in listed] == [
        "activity_newer",
        "own_activity_unreadable",
    ]
    assert not [one for one in browser.get("/api/activities").data["activities"] if one["own"]]
    assert browser.get(f"/api/activities/{newer}").error["code"] == "activity_newer"
    group = browser.post("/api/groups", {"name": "G"}).data["id"]
    created = browser.post(f"/api/groups/{group}/activities", {"activity": newer})
    assert created.error["code"] == "activity_newer"


def test_the_teacher_s_programs_are_in_a_group_of_their_own(teacher: Browser) -> None:
    first, second = (teacher.post("/api/own-activities/programs").data for _ in range(2))
    assert first["group_id"] == second["group_id"]
    assert first["name"] != second["name"]
    teacher.post("/api/groups", {"name": "Tatus"})
    groups = teacher.get("/api/groups").data["groups"]
    assert {one["name"]: one["of_teacher"] for one in groups} == {
        "Tatus": False,
        "Solutions": True,
    }
    teacher.send("DELETE", f"/api/groups/{first['group_id']}")
    assert teacher.post("/api/own-activities/programs").data["group_id"] != first["group_id"]
    teacher.post("/api/teacher/leave")
    assert teacher.post("/api/own-activities/programs").error["code"] == "teacher_only"
