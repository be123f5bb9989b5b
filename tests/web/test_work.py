"""Groups, programs, versions and settings over HTTP."""

from collections.abc import Callable
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.program import reading
from pinel_desktop.program.reading import ParseResult
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
    counted = {"n_programs", "n_in_bin", "n_runs"}
    assert (
        set(group)
        == {
            "id",
            "name",
            "color",
            "picture",
            "robot_name",
            "robot_pattern",
            "has_album",
            "of_teacher",
            "classroom_id",
            "created_at",
        }
        | counted
    )


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


def test_a_save_tells_what_was_the_newest_before_it_and_whether_the_program_is_in_the_bin(
    browser: Browser, program: dict[str, Any], version: dict[str, Any]
) -> None:
    assert (version["before"], version["deleted_at"]) == (None, None)
    versions = f"/api/programs/{program['id']}/versions"
    made_of = {"document": None, "parent_id": version["id"]}
    here = browser.post(versions, {"workspace": {"b": 1}, **made_of}).data
    there = browser.post(versions, {"workspace": {"b": 2}, **made_of}).data
    assert (here["before"], there["before"]) == (version["id"], here["id"])
    browser.send("DELETE", f"/api/programs/{program['id']}")
    assert browser.post(versions, {"workspace": {"b": 3}, **made_of}).data["deleted_at"]


def test_all_windows_hear_of_what_is_saved_thrown_away_and_taken_back(
    browser: Browser, program: dict[str, Any]
) -> None:
    path = f"/api/programs/{program['id']}"
    with browser.stream() as events:
        events.next()
        saved = browser.post(f"{path}/versions", {"workspace": {}, "document": None}).data
        browser.send("DELETE", path)
        browser.post(f"{path}/take-back", {})
        received = [events.next() for _ in range(3)]
    assert {one["type"] for one in received} == {"program"}
    assert {one["program"] for one in received} == {program["id"]}
    assert [one["version"] for one in received] == [saved["id"], None, None]
    assert [one["deleted_at"] is None for one in received] == [True, False, True]


def test_blocks_with_faults_are_kept_and_the_faults_told_in_words(
    browser: Browser, program: dict[str, Any]
) -> None:
    path = f"/api/programs/{program['id']}/versions"
    (fault,) = browser.post(path, {"workspace": {"b": 1}, "document": FAULTY}).data["faults"]
    assert (fault["code"], fault["block"]) == ("distance_out_of_range", "b")
    assert fault["pointer"] == "/commands/0/distance"
    assert "-1" in fault["message"]
    version = browser.get(f"/api/programs/{program['id']}").data["version"]
    assert (version["workspace"], version["document"], version["faults"]) == (
        {"b": 1},
        None,
        [fault],
    )
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


HOSTILE = (
    b'{"pinel_ir": 1, "name": "\\ud800", "commands": [{"action": "repeat", "times": 1'
    + b"0" * 4000
    + b', "commands": [], "block": "\\ud800"}]}'
)


def test_no_document_makes_an_answer_that_cannot_be_written(
    browser: Browser, program: dict[str, Any]
) -> None:
    json_type = {"Content-Type": "application/json"}
    path = f"/api/programs/{program['id']}"
    check = b'{"document": ' + HOSTILE + b"}"
    version = b'{"workspace": {"text": "\\udc00"}, "document": ' + HOSTILE + b"}"
    for where, body in (("/api/check", check), (f"{path}/versions", version)):
        answer = browser.send("POST", where, body=body, headers=json_type)
        assert answer.status == 200, answer.body
        assert answer.data["faults"]
    opened = browser.get(path)
    assert opened.status == 200, opened.body
    assert opened.data["version"]["workspace"] == {"text": "\ufffd"}


def test_faults_that_hold_what_nothing_can_write_are_answered_all_the_same(
    start_app: Callable[..., App], monkeypatch: pytest.MonkeyPatch
) -> None:
    values = {"value": 10**400, "min": -(10**400), "max": float("inf"), "name": ["\ud800"]}

    class Wild:
        code, pointer, block, params = "times_out_of_range", "/\ud800", "\ud800", values

    wild = ParseResult(None, (Wild(),))  # type: ignore[arg-type]
    monkeypatch.setattr(reading, "read_document", lambda source: wild)
    browser = Browser.signed_in(start_app().address)
    (fault,) = browser.post("/api/check", {"document": {}}).data["faults"]
    assert (fault["pointer"], fault["block"]) == ("/\ufffd", "\ufffd")
    assert fault["params"] == {"value": "1e400", "min": "-1e400", "max": "inf", "name": ["\ufffd"]}
    group = browser.post("/api/groups", {"name": "A"}).data
    program = browser.post(f"/api/groups/{group['id']}/programs", {"name": "P"}).data
    path = f"/api/programs/{program['id']}"
    saved = browser.post(f"{path}/versions", {"workspace": {}, "document": {}})
    assert (saved.status, saved.data["faults"]) == (200, [fault])
    assert browser.get(path).data["version"]["faults"] == [fault]
    run = browser.post("/api/runs", {"version_id": saved.data["id"], "world": "empty_room"})
    assert (run.status, run.error["faults"]) == (422, [fault])


def test_of_thousands_of_faults_the_first_hundred_are_told_and_kept(
    app: App, browser: Browser, program: dict[str, Any]
) -> None:
    document = {"pinel_ir": 1, "name": "x", "commands": [{"action": "fly"}] * 20_000}
    checked = browser.post("/api/check", {"document": document})
    path = f"/api/programs/{program['id']}"
    saved = browser.post(f"{path}/versions", {"workspace": {}, "document": document})
    opened = browser.get(path)
    for answer, part in (
        (checked, checked.data),
        (saved, saved.data),
        (opened, opened.data["version"]),
    ):
        assert len(part["faults"]) == 100
        assert part["faults"][0]["pointer"].startswith("/commands/0")
        assert len(answer.body) < 100_000
    version = app._store.versions.newest(program["id"])
    assert version is not None
    assert len(version.faults) == 100
    with_many = app._store.versions.save(program["id"], {"b": 1}, None, version.faults * 20)
    assert len(with_many.faults) == 2000
    assert len(browser.get(path).data["version"]["faults"]) == 100


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
    assert set(room["title"]) == set(LANGUAGES)


@pytest.mark.parametrize("parent", ["abc", "a\0", "\ud800", "0193a5b0-0000-7000-8000-000000000001"])
def test_a_version_is_made_of_one_of_its_own_program_only(
    browser: Browser, program: dict[str, Any], version: dict[str, Any], parent: str
) -> None:
    path = f"/api/programs/{program['id']}/versions"
    body = {"workspace": {"n": 2}, "document": None, "parent_id": parent}
    assert browser.post(path, body).status in (404, 422)
    assert browser.post(path, {**body, "parent_id": version["id"]}).status == 200


def test_a_version_of_another_program_is_no_parent(
    browser: Browser, group: dict[str, Any], version: dict[str, Any]
) -> None:
    other = browser.post(f"/api/groups/{group['id']}/programs", {"name": "Outro"}).data
    body = {"workspace": {}, "document": None, "parent_id": version["id"]}
    refused = browser.post(f"/api/programs/{other['id']}/versions", body)
    assert (refused.status, refused.error["code"]) == (404, "version_not_found")


@pytest.mark.parametrize(
    "workspace",
    ['{"a":' * 9400 + "1" + "}" * 9400, '{"a":' * 500 + "1" * 4400 + "}" * 500],
    ids=["deep", "long number"],
)
def test_what_no_other_pc_could_read_is_not_kept(
    browser: Browser, program: dict[str, Any], workspace: str
) -> None:
    refused = browser.send(
        "POST",
        f"/api/programs/{program['id']}/versions",
        body=f'{{"workspace":{workspace},"document":null}}'.encode(),
        headers={"Content-Type": "application/json"},
    )
    assert refused.status in (400, 422)
    assert browser.get(f"/api/programs/{program['id']}").data["version"] is None


def test_ids_that_nothing_can_write_are_refused(browser: Browser) -> None:
    for path, body in (
        ("/api/groups", {"name": "X", "classroom_id": "\ud800"}),
        ("/api/runs", {"version_id": "\ud800", "world": "empty_room"}),
    ):
        assert browser.post(path, body).status == 422


def test_faults_of_a_deep_document_are_kept(browser: Browser, program: dict[str, Any]) -> None:
    deep: list[Any] = []
    for _ in range(600):
        deep = [deep]
    document = [{"action": "move_forward", "block": "b", "distance": deep}]
    path = f"/api/programs/{program['id']}/versions"
    saved = browser.post(path, {"workspace": {}, "document": document})
    assert saved.status == 200
    assert saved.data["faults"]


def test_a_world_that_is_none_does_not_keep_a_program_from_opening(
    app: App, browser: Browser, program: dict[str, Any]
) -> None:
    assert app._store is not None
    app._store.versions.save(program["id"], {"a": 1}, None, world={"pinel_world": 1, "name": "x"})
    opened = browser.get(f"/api/programs/{program['id']}")
    assert (opened.status, opened.data["version"]["world"]) == (200, None)


def test_a_setup_of_a_newer_release_does_not_close_the_program(app: App, browser: Browser) -> None:
    group = browser.post("/api/groups", {"name": "Os Tatus"}).data
    program = browser.post(f"/api/groups/{group['id']}/programs", {"name": "Um"}).data
    path = f"/api/programs/{program['id']}"
    setup = {"world": "maze", "preset": "realistic", "speed": 2}
    body = {"workspace": {"a": 1}, "document": None, "setup": setup}
    assert browser.post(f"{path}/versions", body).status == 200
    stored = browser.get(path).data["version"]["setup"]
    assert stored == {
        **setup,
        "speed": 2.0,
        "start": None,
        "feedback": "pose",
        "activity": None,
        "n_hints": 0,
        "model": "pioneer_3dx",
        "calibrated_robot": None,
    }
    app._store.versions.save(program["id"], {"a": 2}, None, setup={"planet": "Mars"})
    assert browser.get(path).data["version"]["setup"] is None
    marks = browser.get(f"{path}/versions").data["versions"]
    assert [mark["setup"] for mark in marks] == [None, stored]
    wrong = browser.post(f"{path}/versions", {**body, "setup": {"world": "maze", "speed": 0}})
    assert wrong.status == 422
