"""Nothing that a group did is ever lost: undo after a restart, the line of versions, the bin, notes of the teacher."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

MOVE = "andar para frente"


def build(studio: Studio, *distances: str) -> None:
    """One block, and its distance set anew again and again, each time a version."""
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", MOVE, blocks.below(blocks.start()))
    studio.eventually(studio.actions, ["move_forward"])
    for distance in distances:
        set_distance(studio, distance)


def set_distance(studio: Studio, distance: str) -> None:
    studio.blocks.type_into(studio.blocks.by_words(MOVE), distance)
    studio.eventually(lambda: studio.values("distance"), [float(distance.replace(",", "."))])


def test_undo_goes_on_after_the_app_was_closed(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("Failed to load resource")  # the open page asks for a server that is gone
    studio.enter_group("Os Tatus")
    build(studio, "0,7", "2")
    app.stop()
    expect(studio["gone"]).to_be_visible()

    app.start()
    later = open_studio()
    later["group-card"].filter(has_text="Os Tatus").click()
    later.wait_until_open()
    later["undo"].click()
    later.eventually(lambda: later.values("distance"), [0.7])
    expect(later.blocks.by_words(MOVE)).to_contain_text("0,7")
    later["redo"].click()
    later.eventually(lambda: later.values("distance"), [2])

    later["undo"].click()
    later.eventually(lambda: later.values("distance"), [0.7])
    later.blocks.select(later.blocks.start())
    later.page.keyboard.press("Control+z")
    later.eventually(lambda: later.values("distance"), [1])
    later["undo"].click()
    later.eventually(later.commands, [])
    later["undo"].click()  # nothing is left
    for distance in (1, 0.7, 2):
        later["redo"].click()
        later.eventually(lambda distance=distance: later.values("distance"), [distance])


def test_what_was_undone_is_not_gone_through_again_after_a_restart(
    studio: Studio, open_studio: OpenStudio
) -> None:
    studio.enter_group("Os Tatus")
    build(studio, "0,7", "2")
    studio["undo"].click()
    studio.eventually(lambda: studio.values("distance"), [0.7])

    later = open_studio()
    later["group-card"].filter(has_text="Os Tatus").click()
    later.wait_until_open()
    later["undo"].click()
    later.eventually(lambda: later.values("distance"), [1])
