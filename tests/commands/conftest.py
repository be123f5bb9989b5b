"""No command of a test touches the data of whoever runs the tests."""

from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path))
    monkeypatch.setenv("PINEL_LANG", "en")
    return tmp_path
