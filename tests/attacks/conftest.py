"""Two PCs of a school."""

from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from storage import Store, open_store, text
from storage.exchange import bundle_rules
from tests.attacks.deletions import Lab
from tests.attacks.pins import PIN, Pins


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


@pytest.fixture
def lab(tmp_path: Path) -> Iterator[Lab]:
    """PCs that exchange their work."""
    with ExitStack() as stack:
        yield Lab(tmp_path, stack)


@pytest.fixture
def n_unpacked(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Rows of each chunk of samples that is unpacked."""
    unpacked: list[int] = []

    def note(_blob: bytes, n_rows: int) -> bool:
        unpacked.append(n_rows)
        return True

    monkeypatch.setattr(bundle_rules, "_unpacks", note)
    return unpacked


@pytest.fixture
def pins(here: Store) -> Pins:
    pins = Pins(here.settings)
    pins.sessions.set_pin(PIN)
    return pins
