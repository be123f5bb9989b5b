"""The page with a damaged database, a full disk, or a hung engine."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest
from playwright.sync_api import Route, expect

from pinel_desktop.app import App
from storage.file.backups import make_backup
from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch
from tests.web.fake_engine import FakeEngine

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


def test_a_damaged_file_gives_way_to_its_backup_and_the_page_says_so(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch, tmp_path: Path
) -> None:
    watch.expect("Failed to load resource")  # the open page sends requests to the stopped server
    studio.enter_group("Os Tatus")
    database = tmp_path / "pinel.db"
    assert make_backup(database, NOON)
    app.kill()
    expect(studio["gone"]).to_be_visible()
    for suffix in ("-wal", "-shm"):
        database.with_name(database.name + suffix).unlink(missing_ok=True)
    database.write_bytes(b"no database at all " * 1000)

    app.start()
    reopened = open_studio()
    expect(reopened["notice"]).to_contain_text("voltou a cópia de segurança")
    [damaged] = tmp_path.glob("pinel.damaged-*.db")
    expect(reopened["notice"]).to_contain_text(damaged.name)
    expect(reopened["group-card"].filter(has_text="Os Tatus")).to_be_visible()


def test_a_frozen_engine_is_said_and_the_next_run_works(
    studio: Studio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("503 (SERVICE UNAVAILABLE)")  # response for a Stop that was not confirmed
    studio.enter_group("Os Tatus")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text("andar para frente"), "9")
    studio.eventually(lambda: studio.values("distance"), [9.0])
    studio.run()
    studio.wait_for_phase("running")
    app.freeze_engine()
    studio["stop"].click()
    studio.wait_for_phase("failed")
    # the end of the run removes the message about the unconfirmed Stop
    expect(studio["problem"]).to_have_count(0)
    expect(studio["status-line"]).to_contain_text("foi ligado de novo")
    studio.wait_for_screen("scene")
    studio.run()
    studio.wait_for_phase("running")
    studio["stop"].click()
    studio.wait_for_phase("stopped")


def test_run_starts_an_engine_that_was_given_up(studio: Studio, app: AppProcess) -> None:
    enter_made_group(studio, [("move_forward", 0.1)])

    def state_after_another_crash() -> str:
        app.kill_engine()
        state: str = studio.api("/status")["engine"]
        return state

    studio.eventually(state_after_another_crash, "lost")
    studio.page.reload()
    expect(studio["status-line"]).to_contain_text("Apertem Rodar para ligá-la de novo")
    studio.run()
    studio.wait_for_phase("finished")
    expect(studio["status-line"]).not_to_contain_text("ligá-la")


def test_a_disk_that_fills_up_is_said_and_the_line_goes_by_itself_when_there_is_room(
    open_studio: OpenStudio, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    room = [10**12]
    monkeypatch.setattr("shutil.disk_usage", lambda folder: type("Usage", (), {"free": room[0]}))
    monkeypatch.setenv("PINEL_LANG", "pt")
    with App(tmp_path / "other" / "pinel.db", make_engine=FakeEngine) as app:
        studio = open_studio(app.address)
        expect(studio.page.get_by_role("main")).to_be_visible()
        expect(studio["notice"]).to_have_count(0)
        release = hold_status_of_stream(studio)
        room[0] = 300 * 10**6
        app._maintenance.check_space()
        expect(studio["notice"]).to_contain_text("quase cheio: restam 300 MB")
        release()
        expect(studio["notice"]).to_contain_text("quase cheio: restam 300 MB")
        room[0] = 10**12
        app._maintenance.check_space()
        expect(studio["notice"]).to_contain_text("resolvido")
        expect(studio["notice"]).to_have_count(0, timeout=15_000)
        studio.page.close()


def hold_status_of_stream(studio: Studio) -> Callable[[], None]:
    """Reloads the page.

    Holds its second status request, sent at the stream's start, until the returned function is called.
    """
    page, asked = studio.page, list[Route]()
    answer = studio.api("/status")

    def hold_the_second(route: Route) -> None:
        asked.append(route)
        if len(asked) != 2:
            route.continue_()

    def release() -> None:
        with page.expect_event("requestfinished", lambda one: one.url.endswith("/api/status")):
            asked[1].fulfill(json=answer)

    page.route("**/api/status", hold_the_second)
    page.reload()
    studio.eventually(lambda: len(asked), 2)
    return release
