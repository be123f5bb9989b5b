"""Kiosk mode in the page: files go to and come from drives, and the teacher closes PINEL."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from pinel_desktop.desktop.app_process import AppProcess
from pinel_desktop.instance import RunningInstance
from pinel_desktop.school.teacher import TeacherSessions
from storage import open_store
from storage.exchange.backup_share import SHARED_FOLDER
from tests.e2e.axe import violations
from tests.e2e.studio import Studio
from tests.e2e.watch import Watch

pytestmark = pytest.mark.e2e

PIN = "2718"


class KioskPc:
    """A PC in kiosk mode, whose shared folder stands for a stick; `asked` is what its window was asked for."""

    def __init__(self, folder: Path) -> None:
        self.drive = folder / "PENDRIVE"
        self.drive.mkdir()
        database = folder / "pinel.db"
        with open_store(database) as store:
            store.settings.set(SHARED_FOLDER, str(self.drive))
            TeacherSessions(store.settings).set_pin(PIN)
            written = folder / "some.pinel"
            store.exchange.export(written, app_version="1", computer=store.computers.this())
            self.bundle = written.read_bytes()
        self.asked: list[str] = []
        self.app = AppProcess(
            database, on_request=self.asked.append, on_lost=lambda: None, kiosk="setting"
        )
        self.app.start()
        self._database = database

    def second_start(self) -> RunningInstance:
        """The open PINEL, as a second start finds it."""
        self.app.language()
        known = json.loads(self._database.with_name("pinel.instance.json").read_text("utf-8"))
        return RunningInstance(known["url"], known["secret"], known["pid"])


@pytest.fixture
def pc(tmp_path: Path) -> Iterator[KioskPc]:
    pc = KioskPc(tmp_path)
    yield pc
    pc.app.close()


@pytest.fixture
def studio(browser: Browser, watch: Watch, pc: KioskPc) -> Iterator[Studio]:
    context = browser.new_context(
        viewport={"width": 1366, "height": 768}, locale="pt-BR", reduced_motion="reduce"
    )
    watch.over(context)
    studio = Studio(context.new_page())
    studio.page.goto(pc.app.address())
    yield studio
    watch.settle(studio.page)
    context.close()


def test_a_program_goes_to_a_drive_and_comes_back(studio: Studio, pc: KioskPc) -> None:
    studio.enter_new_group("Os Tatus")
    studio.build_square()
    studio.wait_until_saved()
    studio["open-work"].click()
    studio["program-file"].click()
    studio["drive-save"].click()
    expect(studio["drives"]).to_contain_text("programa-1.pinel")
    assert violations(studio, "drives") == []
    studio["drives-close"].click()
    expect(studio["drives"]).to_have_count(0)
    assert [file.name for file in pc.drive.iterdir()] == ["programa-1.pinel"]

    studio.page.evaluate("location.hash = ''")
    studio.page.get_by_role("button", name="Trazer programas de outro computador").click()
    expect(studio["drive-file"]).to_have_count(1)
    assert violations(studio, "drives") == []
    studio["drive-file"].click()
    studio.wait_until_open()
    assert pc.asked == []


def test_an_opened_file_waits_for_the_teacher(studio: Studio, pc: KioskPc, watch: Watch) -> None:
    watch.expect("403 (FORBIDDEN)")  # before the PIN
    file = pc.drive / "turma.pinel"
    file.write_bytes(pc.bundle)
    pc.second_start().open(str(file))
    expect(studio["pin"]).to_be_visible()
    assert pc.asked == ["show"]
    refused = studio.page.evaluate(
        "path => fetch('/api/bundles/merge', {method: 'POST', body: JSON.stringify({paths: [path]}),"
        " headers: {'Content-Type': 'application/json'}}).then(answer => answer.status)",
        str(file),
    )
    assert refused == 403
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio["opened-file"].get_by_role("checkbox")).to_be_checked()
    studio["merge-files"].click()
    expect(studio["merge-results"]).to_contain_text("nada de novo")


def test_printing_the_album_waits_for_the_pin(studio: Studio, pc: KioskPc, watch: Watch) -> None:
    watch.expect("403 (FORBIDDEN)")  # before the PIN
    studio.enter_new_group("Os Tatus")
    studio.page.evaluate("window.printed = 0; window.print = () => { window.printed += 1 }; null")
    studio["open-album"].click()
    studio["album-print"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    studio.eventually(lambda: studio.page.evaluate("window.printed"), 1)
    expect(studio["album-count"]).to_be_visible()
    assert pc.asked == ["allow_print"]


def test_the_teacher_prints_and_closes_pinel(studio: Studio, pc: KioskPc, watch: Watch) -> None:
    watch.expect("403 (FORBIDDEN)")  # before the PIN
    studio.page.evaluate("window.printed = 0; window.print = () => { window.printed += 1 }; null")
    studio.page.evaluate("location.hash = '#/cards'")
    studio["cards-print"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    studio.eventually(lambda: studio.page.evaluate("window.printed"), 1)
    assert pc.asked == ["allow_print"]
    studio.page.evaluate("location.hash = '#/teacher/computer'")
    expect(studio["kiosk"]).to_be_checked(checked=False)
    expect(studio.page.get_by_text("a permissão acaba em 2 minutos")).to_be_visible()
    assert violations(studio, "kiosk") == []
    studio["kiosk-leave"].click()
    studio.eventually(lambda: pc.asked, ["allow_print", "close"])
