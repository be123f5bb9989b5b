"""Groups, programs, versions and settings over HTTP."""

from typing import Any

import pytest

from pinel_desktop.app import App
from tests.web.browser import Browser
from tests.web.conftest import SQUARE

FAULTY = {
    "pinel_ir": 1,
    "name": "x",
    "commands": [{"action": "move_forward", "block": "b", "distance": -1}],
}


def test_the_status_says_what_the_page_needs_first(app: App, browser: Browser) -> None:
    status = browser.get("/api/status").data
    assert status["engine"] == "ready"
    assert status["run"] is None
    assert status["language"] == "en"
    assert status["database"] == {"path": str(app._database), "writable": True, "notice": None}


def test_a_group_is_made_and_listed_with_its_counts(
    browser: Browser, group: dict[str, Any]
) -> None:
    browser.post(f"/api/groups/{group['id']}/programs", {"name": "P"})
    (listed,) = browser.get("/api/groups").data["groups"]
    assert listed == {**group, "n_programs": 1}
    assert set(group) == {"id", "name", "color", "created_at", "n_programs", "n_runs"}


def test_a_second_group_of_that_name_is_refused(browser: Browser, group: dict[str, Any]) -> None:
    answer = browser.post("/api/groups", {"name": " os  ROBÔS"})
    assert (answer.status, answer.error["code"]) == (409, "group_exists")
    assert group["name"] in answer.error["message"]


def test_a_program_is_renamed(browser: Browser, program: dict[str, Any]) -> None:
    renamed = browser.send("PATCH", f"/api/programs/{program['id']}", {"name": "Triângulo"}).data
    assert renamed == {**program, "name": "Triângulo"}


def test_a_program_opens_with_its_newest_version(
    browser: Browser, program: dict[str, Any], version: dict[str, Any]
) -> None:
    opened = browser.get(f"/api/programs/{program['id']}").data
    assert (opened["id"], opened["n_versions"]) == (program["id"], 1)
    assert opened["version"]["id"] == version["id"]
    assert opened["version"]["workspace"] == {"blocks": {}}
    assert opened["version"]["document"]["commands"][0]["times"] == 4
    assert opened["version"]["faults"] == []


def test_a_new_program_has_no_version(browser: Browser, program: dict[str, Any]) -> None:
    assert browser.get(f"/api/programs/{program['id']}").data["version"] is None


def test_saving_the_same_again_makes_no_version(
    browser: Browser, program: dict[str, Any], version: dict[str, Any]
) -> None:
    path = f"/api/programs/{program['id']}/versions"
    again = browser.post(path, {"workspace": {"blocks": {}}, "document": SQUARE}).data
    assert again == version


def test_blocks_with_faults_are_kept_and_the_faults_told_in_words(
    browser: Browser, program: dict[str, Any]
) -> None:
    path = f"/api/programs/{program['id']}/versions"
    (fault,) = browser.post(path, {"workspace": {"b": 1}, "document": FAULTY}).data["faults"]
    assert (fault["code"], fault["block"]) == ("distance_out_of_range", "b")
    assert fault["pointer"] == "/commands/0/distance"
    assert "-1" in fault["message"]
    kept = browser.get(f"/api/programs/{program['id']}").data["version"]
    assert (kept["workspace"], kept["document"], kept["faults"]) == ({"b": 1}, None, [fault])
    browser.send("PUT", "/api/settings", {"language": "pt-BR"})
    (translated,) = browser.get(f"/api/programs/{program['id']}").data["version"]["faults"]
    assert translated["message"] != fault["message"]


def test_blocks_without_a_document_are_kept(browser: Browser, program: dict[str, Any]) -> None:
    path = f"/api/programs/{program['id']}/versions"
    saved = browser.post(path, {"workspace": {"loose": 1}, "document": None}).data
    assert saved["faults"] == []
    assert browser.get(f"/api/programs/{program['id']}").data["version"]["document"] is None


@pytest.mark.parametrize("n_blocks", [100, 2000])
def test_a_long_column_of_blocks_is_kept_although_each_nests_in_the_one_above(
    browser: Browser, program: dict[str, Any], n_blocks: int
) -> None:
    workspace = b'{"next": {"block": ' * n_blocks + b"{}" + b"}}" * n_blocks
    path = f"/api/programs/{program['id']}/versions"
    answer = browser.send(
        "POST",
        path,
        body=b'{"document": null, "workspace": ' + workspace + b"}",
        headers={"Content-Type": "application/json"},
    )
    assert answer.status == 200, answer.body
    opened = browser.get(f"/api/programs/{program['id']}")
    assert opened.body.count(b'"next":{"block":') == n_blocks


@pytest.mark.parametrize(
    ("document", "codes"), [(SQUARE, []), (FAULTY, ["distance_out_of_range"]), ([], [])]
)
def test_a_document_is_checked_without_being_kept(
    browser: Browser, document: Any, codes: list[str]
) -> None:
    faults = browser.post("/api/check", {"document": document}).data["faults"]
    assert [fault["code"] for fault in faults] == codes


def test_the_language_outlives_the_app(app: App, browser: Browser) -> None:
    browser.send("PUT", "/api/settings", {"language": "es"})
    app.close()
    with App(app._database) as again:
        assert again.language == "es"


def test_every_world_is_told_with_its_walls(browser: Browser) -> None:
    worlds = {world["name"]: world for world in browser.get("/api/worlds").data["worlds"]}
    room = worlds["empty_room"]
    assert room["size_m"] == [8, 8]
    assert len(room["walls"]) >= 4
    assert set(room["title"]) == {"pt-BR", "en", "es"}
