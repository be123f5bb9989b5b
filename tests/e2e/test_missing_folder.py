"""The folder of the database is unreachable: the page reports it, and a person chooses."""

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.watch import Watch

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]


@pytest.fixture
def app(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[AppProcess]:
    """An app whose USB stick was removed since its last start."""
    (tmp_path / "temporary").mkdir()
    monkeypatch.setenv("TMPDIR", str(tmp_path / "temporary"))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "share"))
    stick = tmp_path / "stick"
    stick.mkdir()
    app = AppProcess(stick)
    app.start()
    app.stop()
    shutil.rmtree(stick)
    stick.mkdir()
    app.start()
    yield app
    app.stop()


def test_a_folder_that_is_away_is_named_and_a_person_may_begin_empty(
    app: AppProcess, open_studio: OpenStudio, watch: Watch
) -> None:
    watch.expect("Failed to load resource")  # the open page sends requests to the stopped server
    studio = open_studio()
    expect(studio["notice"]).to_contain_text("não está aqui ou está vazia")
    studio["begin-empty"].click()
    expect(studio["notice"]).to_contain_text("vai começar vazio")
    expect(studio["begin-empty"]).to_have_count(0)
    app.stop()
    app.start()
    again = open_studio()
    again.enter_group("Os Tatus")
    # that the tests' disk is in memory may still be said
    about_the_folder = re.compile("não está aqui|vai começar vazio")
    expect(again["notice"].filter(has_text=about_the_folder)).to_have_count(0)
