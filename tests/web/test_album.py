"""The album of a group over HTTP, and the choice of the teacher to switch it off for a class."""

from typing import Any

import pytest

from pinel_desktop.activities import solution_of
from pinel_desktop.app import App
from storage import RunStart
from tests.storage.sample_documents import WORLD
from tests.web.browser import Browser


@pytest.fixture
def classroom(app: App) -> str:
    return app._store.classrooms.create("9º A").id


@pytest.fixture
def group(app: App, classroom: str) -> str:
    """A group whose only run passed the mission `square`."""
    store = app._store
    group = store.groups.create("Os Tatus", classroom_id=classroom).id
    program = store.programs.create(group, "Quadrado").id
    version = store.versions.save(program, {}, solution_of("square"))
    start = RunStart("sim", "w", WORLD, 1, "1", version_id=version.id, activity="square")
    run = store.runs.begin(start).id
    store.grading_results.record(run, True, {"cases": []})
    return group


def album(browser: Browser, group: str) -> dict[str, Any]:
    found: dict[str, Any] = browser.get(f"/api/groups/{group}/album").data
    return found


def has_album(browser: Browser, group: str) -> bool:
    groups = browser.get("/api/groups").data["groups"]
    return bool(next(one["has_album"] for one in groups if one["id"] == group))


def test_the_album_says_which_run_won_a_sticker_and_when(
    app: App, browser: Browser, group: str
) -> None:
    (run,) = app._store.runs.of_group(group)
    found = album(browser, group)
    won = [one for one in found["stickers"] if one["win"]]
    assert found["enabled"] is True
    assert won == [
        {
            "name": "square",
            "kind": "mission",
            "path": "shapes",
            "title": "A square of 1 m",
            "win": {"won_at": run.started_at, "run_id": run.id},
            "n_done": 0,
            "n_needed": 1,
        }
    ]


def test_an_unknown_group_has_none(browser: Browser) -> None:
    assert browser.get("/api/groups/nobody/album").error["code"] == "group_not_found"


def test_the_teacher_switches_albums_off_for_a_class_and_on_again(
    app: App, browser: Browser, classroom: str, group: str
) -> None:
    teacher = Browser.signed_in(app.address)
    teacher.put("/api/teacher/pin", {"pin": "314159"})
    other = app._store.groups.create("Araras").id
    place = f"/api/classrooms/{classroom}/preset"
    assert browser.put(place, {"album": False}).status == 403
    assert teacher.put(place, {"level": 2, "album": False}).data["album"] is False
    assert album(browser, group) == {"enabled": False, "stickers": []}
    assert (has_album(browser, group), has_album(browser, other)) == (False, True)
    assert album(browser, other)["enabled"] is True
    teacher.put(place, {"level": 2})
    assert has_album(browser, group) is True
    assert [one["name"] for one in album(browser, group)["stickers"] if one["win"]] == ["square"]


@pytest.mark.parametrize("preset", ["{", "[]", '{"album": "no"}', '{"level": 99}'])
def test_a_preset_that_cannot_be_read_leaves_the_album_on(
    app: App, browser: Browser, classroom: str, group: str, preset: str
) -> None:
    store = app._store
    store.class_presets.set(classroom, {"album": False})
    store._database.write(
        lambda db: db.execute("UPDATE class_presets SET preset = ?", [preset]).rowcount
    )
    assert has_album(browser, group) is True
