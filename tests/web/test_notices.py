"""The works of others in the package: the page shows the list that was made with the package."""

import sys
from pathlib import Path

import pytest

from tests.web.browser import Browser


def test_a_program_without_a_package_has_no_list(browser: Browser) -> None:
    assert browser.get("/api/notices").data == {"text": ""}


def test_the_list_of_the_package_is_handed_out(
    browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the Debian package, the file beside the program is a link."""
    file, program = tmp_path / "doc" / "notices.txt", tmp_path / "lib" / "pinel"
    file.parent.mkdir()
    program.parent.mkdir()
    file.write_text("Flask 3: BSD-3-Clause — com ç", "utf-8")
    (program.parent / "THIRD-PARTY-NOTICES.txt").symlink_to(file)
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(program))
    assert browser.get("/api/notices").data == {"text": "Flask 3: BSD-3-Clause — com ç"}
    file.unlink()
    assert browser.get("/api/notices").data == {"text": ""}
