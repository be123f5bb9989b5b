"""A teacher collects the work of a PC that nobody approved yet: its missions count once they are checked."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import expect

from storage import open_store
from tests.attacks.signing import MISSION, Pc
from tests.e2e.axe import violations
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

CONFIRMED_MS = 90_000  # two runs are repeated, by processes of their own on a busy PC


@pytest.fixture
def pupil(tmp_path: Path) -> Iterator[Pc]:
    """A PC with an honest pass and one that its pupils wrote into its database."""
    with open_store(tmp_path / "pupil" / "pinel.db") as store:
        store.computers.rename("PC 7")
        yield Pc(store, tmp_path / "pupil")


def passes(studio: Studio) -> set[str]:
    """Names of the groups that have passed the mission."""
    groups: list[dict[str, Any]] = studio.tell("GET", "/groups")["groups"]
    return {
        one["name"]
        for one in groups
        for tried in studio.tell("GET", f"/groups/{one['id']}/activities")["activities"]
        if tried["name"] == MISSION and tried["passed"]
    }


def test_missions_of_a_pc_that_is_not_approved_count_once_they_are_checked(
    studio: Studio, pupil: Pc
) -> None:
    honest, forged = pupil.drives(), pupil.drives(well=False, passed=True)
    group = pupil.store.groups.get(pupil.store.runs.get(honest).group_id or "")
    folder = pupil.file().parent
    studio.tell("PUT", "/teacher/pin", {"pin": "314159"})
    studio.tell("PUT", "/folders/shared", {"path": str(folder)})
    studio.page.goto(f"{studio.origin}/#/teacher/files")
    studio.page.reload()  # the page has not heard of the PIN
    studio["merge-files"].click()

    came = studio["merge-results"].get_by_role("listitem")
    expect(came).to_contain_text("um PC que você ainda não aprovou")
    expect(studio["computer-trust"]).to_have_attribute("data-trust", "unapproved")
    expect(studio["unconfirmed"]).to_contain_text("1 rodada não confere", timeout=CONFIRMED_MS)
    expect(studio["unconfirmed"]).not_to_contain_text("espera")
    assert passes(studio) == {group.name}
    assert studio.tell("GET", f"/runs/{forged}")["unconfirmed"] == "not_passed"

    studio["approve-computer"].click()
    expect(studio["computer-trust"]).to_have_attribute("data-trust", "approved")
    assert passes(studio) == {group.name}  # an approval does not make the forged pass good
    assert violations(studio) == []
