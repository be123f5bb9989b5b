"""Damaged values without a checksum: names, settings, the teacher's preparations, taught signs."""

from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from pinel_desktop.app import App
from storage.choices import COLORS, GREY
from storage.limits import N_FEATURES
from storage.sqlite import sqlite3
from tests.web.browser import Browser
from tests.web.test_own_activities import DRAFT

PIN = "314159"
NO_TEXT = "CAST(CAST({0} AS BLOB) || x'ff' AS TEXT)"
NO_JSON = "replace({0}, '}}', 'y')"
TEXTS = [
    ("groups", "name"),
    ("groups", "color"),
    ("groups", "picture"),
    ("groups", "robot_name"),
    ("groups", "robot_pattern"),
    ("groups", "used_at"),
    ("classrooms", "name"),
    ("programs", "name"),
    ("lessons", "title"),
    ("lessons", "activity"),
    ("lessons", "opened_at"),
    ("own_activities", "title"),
    ("taught_signs", "sign"),
    ("computers", "name"),
]
OBJECTS = [
    ("own_activities", "document"),
    ("own_activities", "goal"),
    ("class_presets", "preset"),
    ("settings", "value"),
]
DAMAGES = {
    "no text": [(table, column, NO_TEXT) for table, column in TEXTS + OBJECTS],
    "no JSON": [(table, column, NO_JSON) for table, column in OBJECTS],
    "no samples": [("taught_signs", "samples", "substr({0}, 2)")],
    "not finite": [("taught_signs", "samples", "CAST(x'ff7f' || substr({0}, 3) AS BLOB)")],
}


@contextmanager
def disk(database: Path) -> Iterator[sqlite3.Connection]:
    with closing(sqlite3.connect(database)) as db, db:
        yield db


def prepared(app: App) -> list[str]:
    """Creates two groups in a class with all a teacher prepares; returns the addresses that the page requests."""
    tab = Browser.signed_in(app.address)
    tab.put("/api/teacher/pin", {"pin": PIN})
    classroom = tab.post("/api/classrooms", {"name": "9º A"}).data["id"]
    tab.post("/api/classrooms", {"name": "9º B"})
    groups = [
        tab.post("/api/groups", {"name": name, "classroom_id": classroom}).data["id"]
        for name in ("Robôs", "Tatus")
    ]
    for group in groups:
        tab.post(f"/api/groups/{group}/programs", {"name": "Quadrado"})
    made = tab.post("/api/own-activities", DRAFT).data["id"]
    preset = {"level": 2, "world": "maze", "swap_minutes": 10, "activity": made}
    tab.put(f"/api/classrooms/{classroom}/preset", preset)
    lesson = tab.post(f"/api/classrooms/{classroom}/lessons", {"title": "", "activity": made}).data
    app._store.taught_signs.add(classroom, "oi", bytes(2 * N_FEATURES))
    return [
        "/api/groups",
        "/api/classrooms",
        f"/api/classrooms/{classroom}/lesson",
        f"/api/classrooms/{classroom}/lessons",
        f"/api/classrooms/{classroom}/signs",
        "/api/own-activities",
        "/api/activities",
        "/api/real-robots",
        "/api/computer",
        "/api/status",
        "/api/teacher",
        "/api/bundles/heard",
        "/api/runs",
        "/api/examples",
        f"/api/lessons/{lesson['id']}/review",
        f"/api/groups/{groups[0]}/programs",
        f"/api/groups/{groups[0]}/bin",
        f"/api/groups/{groups[0]}/activities",
        f"/api/groups/{groups[0]}/notes",
    ]


def spoil(database: Path, table: str, column: str, damage: str) -> None:
    with disk(database) as db:
        where = "WHERE key NOT LIKE '%computer_id%'" if table == "settings" else ""
        db.execute(f"UPDATE {table} SET {column} = {damage.format(column)} {where}")


@pytest.mark.parametrize("kind", DAMAGES)
def test_all_lists_still_answer(start_app: Callable[..., App], database: Path, kind: str) -> None:
    with App(database) as app:
        paths = prepared(app)
    for table, column, damage in DAMAGES[kind]:
        spoil(database, table, column, damage)
    tab = Browser.signed_in(start_app().address)
    assert tab.post("/api/teacher/enter", {"pin": PIN}).status == 200
    refused = [(path, answer.text) for path in paths if (answer := tab.get(path)).status != 200]
    assert not refused


def test_a_damaged_name_is_seen_and_corrected_by_hand(
    app: App, browser: Browser, database: Path
) -> None:
    prepared(app)
    spoil(database, "groups", "name", NO_TEXT)
    spoil(database, "groups", "color", "'#1f6f8\"'")
    first, second = browser.get("/api/groups").data["groups"]
    assert {first["name"], second["name"]} == {"Robôs\ufffd", "Tatus\ufffd"}
    assert first["color"] == GREY
    answer = browser.patch(f"/api/groups/{first['id']}", {"name": "Onças", "color": COLORS[0]})
    assert (answer.data["name"], answer.data["color"]) == ("Onças", COLORS[0])
    created = browser.post(f"/api/groups/{first['id']}/programs", {"name": "Depois"})
    assert created.status == 200


def test_of_a_class_the_signs_that_can_be_read_are_there(app: App, database: Path) -> None:
    prepared(app)
    signs, (classroom, _) = app._store.taught_signs, app._store.classrooms.all()
    signs.add(classroom.id, "tchau", bytes(2 * N_FEATURES))
    spoil(database, "taught_signs", "samples", "CASE sign WHEN 'oi' THEN x'ff7f' ELSE samples END")
    assert [one.sign for one in signs.of_classroom(classroom.id)] == ["tchau"]
