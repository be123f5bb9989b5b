"""A PC whose disk is as before after each start: the page says so, and the group takes its work along."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import expect

from pinel_desktop.settings import RESETS, Settings
from tests.e2e.axe import violations
from tests.e2e.studio import Studio
from tests.e2e.test_kiosk import KioskPc, studio

__all__ = ["studio"]  # a fixture

pytestmark = pytest.mark.e2e


@pytest.fixture
def pc(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[KioskPc]:
    """A PC in kiosk mode, of which the technician said that it resets."""
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.delenv("PINEL_HOME", raising=False)
    folder = tmp_path / "pinel"
    folder.mkdir()
    Settings.beside(folder / "pinel.db").choose(RESETS, "1")
    pc = KioskPc(folder)
    yield pc
    pc.app.close()


def test_a_group_gets_a_notice_and_exports_all_its_work(studio: Studio, pc: KioskPc) -> None:
    expect(studio["notice"]).to_contain_text("Este computador esquece tudo")
    expect(studio["group-file"]).to_have_count(0)  # nobody's work is open
    studio.enter_new_group("Os Tatus")
    studio.build_square()
    studio.wait_until_saved()
    assert violations(studio, "notice") == []
    studio["group-file"].click()
    studio["drive-save"].click()
    expect(studio["drives"]).to_contain_text("Salvo em PENDRIVE como os-tatus")
    studio["drives-close"].click()
    assert [file.suffix for file in pc.drive.iterdir()] == [".pinel"]
    studio.page.evaluate("location.hash = ''")
    studio.page.get_by_role("button", name="Trazer programas de outro computador").click()
    studio["drive-file"].click()
    studio.wait_until_open()
