"""Worlds over HTTP: shipped worlds, and worlds of groups."""

from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.web.models.worlds import Title
from pinel_desktop.web.responses import plain
from sim.document import Box, WorldDocument
from sim.parsing import read_world
from sim.world import DEFAULT_BOX_MASS_KG, list_worlds
from tests.storage.sample_runs import ended
from tests.web.browser import Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine

OWN: dict[str, Any] = {
    "pinel_world": 1,
    "name": "own",
    "title": "A nossa sala",
    "size_m": [4, 4],
    "start": {"x_m": 1, "y_m": 0, "heading_deg": 90},
    "walls": [{"from": [-2, -2], "to": [2, -2]}],
    "boxes": [{"center": [-1, 0], "size": [0.4, 0.4], "movable": True, "mass_kg": 3}],
}
CROSSING: dict[str, Any] = {
    **OWN,
    "walls": [{"from": [-1.5, -1], "to": [-1.5, 1]}, {"from": [-2, 0.5], "to": [-0.5, 0.5]}],
}


def save(browser: Browser, program: dict[str, Any], world: Any) -> Any:
    return browser.post(
        f"/api/programs/{program['id']}/versions",
        {"workspace": {}, "document": SQUARE, "world": world},
    )


def test_a_sound_world_is_checked_without_faults(browser: Browser) -> None:
    assert browser.post("/api/worlds/check", {"world": OWN}).data == {"faults": []}


@pytest.mark.parametrize(
    "unusual",
    [{"pinel_world": 10**400}, {"pinel_world": True}, {"\ud800": 1, "walls": [{"to": 5}]}],
)
def test_what_no_model_foresaw_is_a_fault_too(browser: Browser, unusual: dict[str, Any]) -> None:
    faults = browser.post("/api/worlds/check", {"world": {**OWN, **unusual}}).data["faults"]
    assert faults
    assert all(fault["message"] and fault["remedy"] for fault in faults)


def test_faults_of_a_world_are_told_in_words_with_their_places(browser: Browser) -> None:
    (fault,) = browser.post("/api/worlds/check", {"world": CROSSING}).data["faults"]
    assert (fault["code"], fault["pointer"], fault["block"]) == ("walls_cross", "/walls/1", None)
    assert fault["message"] == "Walls 1 and 2 cross."
    assert fault["params"]["other_pointer"] == "/walls/0"


@pytest.mark.parametrize("world", [7, None, [], "x", {"pinel_world": 1}, {"\ud800": 10**400}])
def test_anything_can_be_checked(browser: Browser, world: Any) -> None:
    answer = browser.post("/api/worlds/check", {"world": world})
    assert answer.status == 200
    assert answer.data["faults"]


def test_a_version_keeps_its_own_world_in_the_normal_form(
    browser: Browser, program: dict[str, Any]
) -> None:
    saved = save(browser, program, OWN).data
    world = browser.get(f"/api/programs/{program['id']}").data["version"]["world"]
    assert world["boxes"] == [
        {"center": [-1, 0], "size": [0.4, 0.4], "heading_deg": 0, "movable": True, "mass_kg": 3}
    ]
    assert world["title"] == "A nossa sala"
    assert save(browser, program, world).data["id"] == saved["id"]


def test_a_version_without_a_world_says_null(browser: Browser, program: dict[str, Any]) -> None:
    with_world = save(browser, program, OWN).data["id"]
    without = save(browser, program, None).data["id"]
    assert without != with_world
    assert browser.get(f"/api/programs/{program['id']}").data["version"]["world"] is None


def test_a_faulty_world_is_refused_with_its_faults_and_nothing_is_kept(
    browser: Browser, program: dict[str, Any]
) -> None:
    answer = save(browser, program, CROSSING)
    assert (answer.status, answer.error["code"]) == (422, "invalid_world")
    assert [fault["code"] for fault in answer.error["faults"]] == ["walls_cross"]
    assert browser.get(f"/api/programs/{program['id']}").data["n_versions"] == 0


def test_a_run_in_the_version_s_own_world_keeps_the_document(
    browser: Browser, engine: FakeEngine, program: dict[str, Any]
) -> None:
    version = save(browser, program, OWN).data
    run = browser.post("/api/runs", {"version_id": version["id"], "world": "own"}).data
    assert run["world"] == "own"
    assert engine.start_spec["world"] == read_world(OWN, robot_radius_m=0.25).document
    read = browser.get(f"/api/runs/{run['id']}").data
    assert read["world_document"]["walls"] == OWN["walls"]
    assert read["version"]["world"]["name"] == "own"


def test_a_version_without_a_world_of_its_own_says_so_in_words(
    browser: Browser, version: dict[str, Any]
) -> None:
    answer = browser.post("/api/runs", {"version_id": version["id"], "world": "own"})
    assert (answer.status, answer.error["code"]) == (422, "world_missing")
    assert "no world of its own" in answer.error["message"]


@pytest.mark.parametrize(
    ("start", "code"),
    [
        ({"x_m": -1, "y_m": 0, "heading_deg": 0}, "start_in_box"),
        ({"x_m": 0, "y_m": -1.9, "heading_deg": 0}, "start_off_floor"),
        ({"x_m": 0, "y_m": 0, "heading_deg": 1e9}, "world_value_too_large"),
    ],
)
def test_a_start_without_room_for_the_robot_is_refused_in_words_of_its_own(
    browser: Browser, program: dict[str, Any], start: dict[str, Any], code: str
) -> None:
    version = save(browser, program, OWN).data
    request = {"version_id": version["id"], "world": "own", "start": start}
    answer = browser.post("/api/runs", request)
    assert (answer.status, answer.error["code"]) == (422, code)


@pytest.mark.parametrize("document", list_worlds(), ids=lambda d: d["name"])
def test_what_the_page_is_told_of_a_world_can_be_kept_as_one_s_own(
    browser: Browser, document: dict[str, Any]
) -> None:
    worlds = {world["name"]: world for world in browser.get("/api/worlds").data["worlds"]}
    assert (
        browser.post("/api/worlds/check", {"world": worlds[document["name"]]}).data["faults"] == []
    )


def test_the_interface_describes_worlds_as_the_reader_reads_them(browser: Browser) -> None:
    schemas = browser.get("/api/openapi.json").data["components"]["schemas"]
    described = set(schemas["World"]["properties"])
    assert described == {field.alias or name for name, field in WorldDocument.model_fields.items()}
    assert set(schemas["Box"]["properties"]) == set(Box.model_fields)
    assert schemas["Box"]["properties"]["mass_kg"]["default"] == DEFAULT_BOX_MASS_KG


def test_a_world_that_was_kept_before_a_rule_came_opens_runs_and_is_kept_again(
    app: App, browser: Browser, program: dict[str, Any], engine: FakeEngine
) -> None:
    thin = {"center": [-1, 0], "size": [0.02, 0.4], "movable": True, "mass_kg": 0.1}
    normal = read_world(OWN, robot_radius_m=0.25).document
    assert normal is not None
    old = {**normal, "boxes": [{**thin, "heading_deg": 0.0}]}
    assert app._store is not None
    app._store.versions.save(program["id"], {"blocks": 1}, SQUARE, [], old)
    opened = browser.get(f"/api/programs/{program['id']}").data["version"]["world"]
    saved = save(browser, program, opened)
    assert saved.status == 200
    request = {"version_id": saved.data["id"], "world": "own"}
    moved = {"x_m": 1.0, "y_m": -1.0, "heading_deg": 0.0}
    assert browser.post("/api/runs", {**request, "start": moved}).status == 200
    assert engine.start_spec["world"] == {**old, "start": moved}
    engine.send(ended(engine.start_spec["run"], 0, 0))
    nowhere = browser.post("/api/runs", {**request, "start": {**moved, "y_m": -2.0}})
    assert nowhere.error["code"] in ("start_in_wall", "start_off_floor")
    changed = save(browser, program, {**opened, "title": "x"})
    assert [fault["code"] for fault in changed.error["faults"]] == [
        "box_too_thin",
        "box_mass_wrong",
    ]


def test_a_title_in_a_further_language_is_answered_under_its_tag() -> None:
    title = {"pt-BR": "Sala", "en": "Room", "es": "Sala", "fr": "Salle"}
    assert plain(Title.model_validate(title)) == title
