"""What a group sees when the file or the disk is in trouble."""

import re
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import pytest
from playwright.sync_api import Route, expect

from pinel_desktop.app import App
from storage.file.backups import make_backup
from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch
from tests.web.fake_engine import FakeEngine

NOON = datetime(2026, 11, 21, 12, 0, 0, tzinfo=UTC)

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]


def test_a_damaged_file_gives_way_to_its_backup_and_the_page_says_so(
    studio: Studio, open_studio: OpenStudio, app: AppProcess, watch: Watch, tmp_path: Path
) -> None:
    watch.expect("Failed to load resource")  # the open page asks for a server that is gone
    studio.enter_group("Os Tatus")
    database = tmp_path / "pinel.db"
    assert make_backup(database, NOON)
    app.kill()
    expect(studio["gone"]).to_be_visible()
    for suffix in ("-wal", "-shm"):
        database.with_name(database.name + suffix).unlink(missing_ok=True)
    database.write_bytes(b"no database at all " * 1000)

    app.start()
    later = open_studio()
    expect(later["notice"]).to_contain_text("voltou a cópia de segurança")
    [damaged] = tmp_path.glob("pinel.damaged-*.db")
    expect(later["notice"]).to_contain_text(damaged.name)
    expect(later["group-card"].filter(has_text="Os Tatus")).to_be_visible()


def test_a_frozen_engine_is_said_and_the_next_run_works(
    studio: Studio, app: AppProcess, watch: Watch
) -> None:
    watch.expect("503 (SERVICE UNAVAILABLE)")  # a Stop that was not confirmed
    studio.enter_group("Os Tatus")
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_words("andar para frente"), "9")
    studio.eventually(lambda: studio.values("distance"), [9.0])
    studio.run()
    studio.wait_for_phase("running")
    app.freeze_engine()
    studio["stop"].click()
    studio.wait_for_phase("failed")
    expect(studio["problem"]).to_have_count(0)  # that Stop was not confirmed is over with the run
    expect(studio["status-line"]).to_contain_text("foi ligado de novo")
    studio.run()
    studio.wait_for_phase("running")
    studio["stop"].click()
    studio.wait_for_phase("stopped")


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
    """Loads the page anew; the status that it asks for when its stream begins is answered, as it was, when called."""
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


def test_a_group_that_is_deleted_under_its_program_is_told_once_and_can_take_its_text(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("404 (NOT FOUND)")
    answers: list[int] = []
    studio.page.on("response", lambda answer: answers.append(answer.status))
    studio.enter_group("Os Tatus")
    studio.build_square("0,3")
    studio.wait_until_saved()
    [group] = studio.api("/groups")["groups"]
    studio.tell("PUT", "/teacher/pin", {"pin": "314159"})
    studio.tell("DELETE", f"/groups/{group['id']}")

    studio.page.clock.install()
    studio.blocks.type_into(studio.blocks.by_words("andar para frente"), "0,5")
    expect(studio["deleted"]).to_contain_text("O grupo foi apagado")
    studio["run"].click()
    studio.page.clock.run_for(10_000)  # longer than any pause between two tries
    studio.page.evaluate("fetch('/api/status')")  # a try would be answered before
    assert answers.count(404) == 1
    expect(studio["problem"]).to_have_count(0)
    expect(studio["unsaved"]).to_have_count(0)
    expect(studio["saved-mark"]).to_have_text("Não foi salvo")
    expect(studio["header-group"]).to_have_count(0)
    expect(studio["program-name"]).to_have_count(0)
    expect(studio["open-work"]).to_be_disabled()

    with studio.page.expect_download() as taken:
        studio["take-text"].click()
    assert taken.value.suggested_filename == "programa-1.py"
    assert "0.5" in taken.value.path().read_text(encoding="utf-8")
    studio["deleted"].get_by_role("link").click()
    expect(studio["group-name"]).to_be_visible()


def test_the_blocks_stay_in_sight_while_the_server_is_gone(studio: Studio, watch: Watch) -> None:
    watch.expect("Failed to load resource")
    studio.enter_group("Os Tatus")
    studio.build_square("0,3")
    studio.wait_until_saved()
    place = studio.page.url
    studio.page.route("**/api/**", lambda route: route.abort())
    studio.blocks.type_into(studio.blocks.by_words("andar para frente"), "0,5")
    for way_out in ("open-history", "open-work", "home"):
        studio[way_out].click()
        expect(studio["gone"]).to_be_visible()
        expect(studio.blocks.by_words("andar para frente")).to_contain_text("0,5")
        expect(studio.page).to_have_url(place)
    expect(studio["problem"]).to_have_count(0)

    studio.page.unroute("**/api/**")
    expect(studio["gone"]).to_have_count(0, timeout=15_000)
    studio.wait_until_saved()


def test_a_screen_that_could_not_be_fetched_is_no_dead_end(studio: Studio, watch: Watch) -> None:
    watch.expect("Failed to load resource")
    studio.enter_group("Os Tatus")
    screen = re.compile(r"WorkScreen.*\.js")
    studio.page.route(screen, lambda route: route.abort())
    studio["open-work"].click()
    expect(studio["problem"]).to_be_visible()
    expect(studio["fetch-again"]).to_be_visible()
    studio.page.unroute(screen)
    studio["fetch-again"].click()
    expect(studio["program-card"]).to_be_visible()


class Failing:
    """Answers requests with an error: at once, or when they are released."""

    def __init__(self) -> None:
        self.held: list[Route] | None = None

    def answer(self, route: Route) -> None:
        if self.held is None:
            route.fulfill(status=500, body="{}")
        else:
            self.held.append(route)

    def hold(self) -> None:
        self.held = []

    def release(self) -> None:
        held, self.held = self.held or [], None
        for route in held:
            self.answer(route)


@pytest.mark.parametrize(
    ("place", "question", "sign"),
    [
        ("", "**/api/status", "group-card"),
        ("", "**/api/groups", "group-card"),
        ("work/{group}", "**/api/groups/*/runs**", "program-card"),
        ("program/{program}", "**/api/programs/*", "run"),
    ],
)
def test_a_screen_whose_first_question_is_answered_with_an_error_says_so_and_can_be_tried_again(
    studio: Studio, watch: Watch, place: str, question: str, sign: str
) -> None:
    watch.expect("500 (Internal Server Error)")
    studio.enter_group("Os Tatus")
    [group] = studio.api("/groups")["groups"]
    where = place.format(group=group["id"], program=studio.program_id)
    failing = Failing()
    studio.page.route(question, failing.answer)
    studio.page.goto(f"{studio.origin}/#/{where}")
    studio.page.reload()
    expect(studio["not-loaded"]).to_be_visible()
    expect(studio["problem"]).to_be_visible()
    expect(studio.page.get_by_role("main")).not_to_have_attribute("aria-busy", "true")

    failing.hold()  # others may ask the same; the screen's own request is on its way when its button is busy
    studio["try-again"].click()
    expect(studio["try-again"]).to_have_attribute("aria-busy", "true")
    failing.release()  # and it goes on failing
    expect(studio["try-again"]).not_to_have_attribute("aria-busy", "true")
    studio.page.unroute(question)
    studio["try-again"].click()
    expect(studio[sign].first).to_be_visible()
    expect(studio["not-loaded"]).to_have_count(0)


@pytest.mark.parametrize("place", ["program", "versions", "run", "work"])
def test_what_is_not_there_leaves_no_other_program_in_the_header(
    studio: Studio, watch: Watch, place: str
) -> None:
    watch.expect("404 (NOT FOUND)")
    studio.enter_group("Os Tatus")
    studio.page.goto(f"{studio.origin}/#/{place}/nothing")
    expect(studio["problem"]).to_be_visible()
    expect(studio["header-group"]).to_have_count(0)
    expect(studio["program-name"]).to_have_count(0)
    expect(studio["saved-mark"]).to_have_count(0)
    studio.page.get_by_role("link", name="Voltar ao início").click()
    expect(studio["group-card"]).to_be_visible()
