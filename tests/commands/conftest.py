"""Commands of tests use a temporary data folder."""

from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path))
    monkeypatch.setenv("PINEL_LANG", "en")
    return tmp_path
