"""Damaged versions over HTTP: each is one error with a message, and every list still works."""

from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from storage.sqlite import sqlite3
from tests.web.browser import Browser
from tests.web.conftest import SQUARE

DAMAGES = {
    "malformed JSON": "UPDATE versions SET workspace = '{', setup = '{' WHERE number = 2",
    "no text": "UPDATE versions SET workspace = CAST(x'7bff7d' AS TEXT), setup = CAST(x'ff' AS TEXT) WHERE number = 2",
    "other JSON": "UPDATE versions SET workspace = '[]', faults = '5', setup = '7' WHERE number = 2",
    "no time": "UPDATE versions SET created_at = CAST(x'ff' AS TEXT) WHERE number = 2",
}
# the store has no checksum of a row of an earlier release; a value is damaged if it cannot be read
UNREADABLE = ("malformed JSON", "no text", "other JSON")


@pytest.fixture
def newest(browser: Browser, program: dict[str, Any], version: dict[str, Any]) -> Any:
    body = {"workspace": {"blocks": {"n": 2}}, "document": SQUARE, "parent_id": version["id"]}
    return browser.post(f"/api/programs/{program['id']}/versions", body).data


def damage(database: Path, *statements: str) -> None:
    with closing(sqlite3.connect(database)) as db, db:
        for statement in statements:
            db.execute(statement)


@pytest.mark.parametrize("change", DAMAGES.values(), ids=DAMAGES)
@pytest.mark.usefixtures("newest")
def test_a_damaged_version_is_one_error_with_the_last_sound_one(
    change: str, browser: Browser, database: Path, program: dict[str, Any], version: dict[str, Any]
) -> None:
    damage(database, change)
    _expect_report_and_further_work(browser, program, version)


@pytest.mark.parametrize("name", UNREADABLE)
@pytest.mark.usefixtures("newest")
def test_so_is_one_of_an_earlier_release(
    name: str, browser: Browser, database: Path, program: dict[str, Any], version: dict[str, Any]
) -> None:
    damage(database, DAMAGES[name], "DELETE FROM content_sums")
    _expect_report_and_further_work(browser, program, version)


def _expect_report_and_further_work(
    browser: Browser, program: dict[str, Any], version: dict[str, Any]
) -> None:
    place = f"/api/programs/{program['id']}"
    answer = browser.get(place)
    assert (answer.status, answer.error["code"]) == (409, "version_damaged")
    assert answer.error["params"]["sound"] == version["id"]
    assert browser.get(f"{place}?sound=true").data["version"]["id"] == version["id"]
    group = f"/api/groups/{program['group_id']}"
    for list_of in (f"{place}/versions", f"{group}/programs", f"{group}/runs"):
        assert browser.get(list_of).status == 200
    body = {"workspace": {"blocks": {"n": 3}}, "document": None, "parent_id": version["id"]}
    saved = browser.post(f"{place}/versions", body)
    assert saved.status == 200
    assert browser.get(place).data["version"]["id"] == saved.data["id"]
