"""Two PCs of a school."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from storage import Store, open_store, text


@pytest.fixture
def here(tmp_path: Path) -> Iterator[Store]:
    with open_store(tmp_path / "here.db") as store:
        yield store


@pytest.fixture
def there(tmp_path: Path) -> Iterator[Store]:
    with open_store(tmp_path / "there.db") as store:
        yield store


@pytest.fixture
def fresh_ids(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a test makes the ids of this process follow is forgotten after it."""
    monkeypatch.setattr(text, "_ids", text._Ids())
