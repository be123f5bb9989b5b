"""The app as a whole, with a fake engine: it starts whatever the database is like, is there once, ends fast."""

import json
import os
import stat
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.errors import PinelError
from pinel_desktop.instance import AlreadyRunningError, InstanceLock
from pinel_desktop.paths import data_folder, database_path
from pinel_desktop.web.services import WindowRequest
from storage import RunStart, open_store
from storage.file.backups import make_backup
from storage.sqlite import sqlite3
from tests.storage.sample_runs import ended, sample
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

CLOSE_LIMIT_S = 2.0
READY_S = 10.0


@pytest.fixture
def database(tmp_path: Path) -> Path:
    return tmp_path / "Ação" / "pinel.db"


@pytest.fixture
def start_app(database: Path) -> Iterator[Callable[..., App]]:
    with ExitStack() as stack:

        def start(path: Path = database, **options: Any) -> App:
            return stack.enter_context(App(path, **{"make_engine": FakeEngine, **options}))

        yield start


def status_of(app: App) -> Any:
    return Browser.signed_in(app.address).get("/api/status").data


def test_the_database_is_where_it_was_asked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PINEL_HOME", str(tmp_path / "home"))
    assert database_path() == tmp_path / "home" / "pinel.db"
    assert database_path(tmp_path / "other.db") == tmp_path / "other.db"
    (tmp_path / "link.db").symlink_to(tmp_path / "other.db")
    assert database_path(tmp_path / "link.db") == tmp_path / "other.db"
    monkeypatch.delenv("PINEL_HOME")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "share"))
    monkeypatch.setenv("HOME", str(tmp_path))
    assert data_folder().name == "pinel"
    assert database_path().is_absolute()


def test_the_instance_file_is_for_this_user_alone_and_goes_with_the_app(
    database: Path, start_app: Callable[..., App]
) -> None:
    app = start_app()
    file = database.with_name("pinel.instance.json")
    announced = json.loads(file.read_text("utf-8"))
    assert announced["pid"] == os.getpid()
    if os.name == "posix":
        assert stat.S_IMODE(file.stat().st_mode) == 0o600
    app.close()
    assert not file.exists()


class ShownWindow:
    """A window that tells when it was brought forward."""

    kiosk = None

    def __init__(self, shown: threading.Event) -> None:
        self._shown = shown

    def ask(self, request: WindowRequest) -> None:
        assert request == "show"
        self._shown.set()

    def present(self, address: str | None) -> bool:
        return False


def test_a_second_start_is_led_to_the_first(start_app: Callable[..., App]) -> None:
    shown = threading.Event()
    start_app(window=ShownWindow(shown))
    with pytest.raises(AlreadyRunningError) as caught:
        start_app()
    caught.value.running.show()
    assert shown.is_set()
    browser = Browser.signed_in(caught.value.running.fresh_link())
    assert browser.get("/api/status").status == 200


def test_a_second_start_with_a_file_offers_it_to_the_first(
    start_app: Callable[..., App], tmp_path: Path
) -> None:
    shown = threading.Event()
    first = start_app(window=ShownWindow(shown))
    with pytest.raises(AlreadyRunningError) as caught:
        start_app()
    file = str(tmp_path / "ação \n.pinel")
    caught.value.running.open(file)
    assert shown.is_set()
    browser = Browser.signed_in(first.address)
    browser.put("/api/teacher/pin", {"pin": "314159"})
    offer = browser.get("/api/folders").data["opened"]
    assert (offer["name"], offer["problem"]["code"]) == ("ação \n.pinel", "bundle_missing")


def test_an_instance_file_that_was_left_behind_is_taken_over(
    database: Path, start_app: Callable[..., App]
) -> None:
    database.parent.mkdir()
    stale = {"url": "http://127.0.0.1:9", "secret": "old", "pid": 1}
    database.with_name("pinel.instance.json").write_text(json.dumps(stale), "utf-8")
    assert status_of(start_app())["database"]["writable"] is True


@pytest.mark.parametrize(
    "content", ["", "[]", "{}", '{"url": "file:///etc/passwd", "secret": "x", "pid": 1}']
)
def test_a_first_app_that_does_not_answer_is_told_with_a_remedy(
    database: Path, content: str
) -> None:
    first, second = InstanceLock(database), InstanceLock(database)
    first.acquire()
    database.with_name("pinel.instance.json").write_text(content, "utf-8")
    with pytest.raises(PinelError, match="instance_silent"):
        second.acquire(wait_s=0)
    first.release()
    second.acquire(wait_s=0)
    second.release()


def test_a_taken_port_is_told_and_leaves_nothing_behind(
    tmp_path: Path, database: Path, start_app: Callable[..., App]
) -> None:
    port = Browser.at(start_app(tmp_path / "first.db").address).port
    with pytest.raises(PinelError, match="port_taken") as caught:
        start_app(port=port)
    assert caught.value.params["port"] == port
    assert status_of(start_app())["database"]["writable"] is True


def test_the_app_starts_with_a_damaged_database_and_says_so(
    database: Path, start_app: Callable[..., App]
) -> None:
    database.parent.mkdir()
    database.write_bytes(b"no database at all " * 500)
    app = start_app()
    found = status_of(app)["database"]
    assert (found["writable"], found["notice"]["code"]) == (True, "database_set_aside")
    (aside,) = database.parent.glob("pinel.damaged-*.db")
    assert aside.name in found["notice"]["details"]


def test_the_app_starts_without_a_usable_database_and_keeps_nothing(
    database: Path, start_app: Callable[..., App]
) -> None:
    database.mkdir(parents=True)
    app = start_app()
    found = status_of(app)["database"]
    assert found["writable"] is False
    assert found["notice"]["remedy"]
    browser = Browser.signed_in(app.address)
    assert browser.get("/api/groups").data == {"groups": []}
    assert browser.post("/api/groups", {"name": "A"}).error["code"] == found["notice"]["code"]
    assert browser.send("PUT", "/api/settings", {"language": "es"}).status == 200
    assert app.language == "es"


def test_a_run_that_was_cut_off_is_closed_at_the_next_start(
    database: Path, start_app: Callable[..., App]
) -> None:
    with open_store(database) as store:
        run = store.runs.begin(
            RunStart(link="sim", world="w", world_document={}, seed=0, app_version="1")
        )
    start_app()
    with open_store(database) as store:
        assert store.runs.get(run.id).reason == "interrupted"


def starts(app: App, within_s: float) -> bool:
    """Whether the engine of the app starts within this time."""
    assert isinstance(app._engine, FakeEngine)
    return app._engine.started.wait(within_s)


def test_the_engine_waits_for_the_first_page(start_app: Callable[..., App]) -> None:
    """It would take the processor from the page that is being drawn."""
    app = start_app(engine_after_s=60.0)
    assert not starts(app, 0.1)
    with Browser.signed_in(app.address).stream() as events:
        events.next()
        assert starts(app, READY_S)


def test_the_engine_does_not_wait_for_ever_for_a_page(start_app: Callable[..., App]) -> None:
    app = start_app(engine_after_s=0.01)
    assert starts(app, READY_S)


def test_an_app_that_closes_before_its_first_page_starts_no_engine(
    start_app: Callable[..., App],
) -> None:
    app = start_app(engine_after_s=60.0)
    app.close()
    assert not starts(app, 0.0)


def test_closing_in_the_middle_of_a_run_is_quick_and_keeps_it(
    database: Path, start_app: Callable[..., App]
) -> None:
    app = start_app()
    engine = app._engine
    assert isinstance(engine, FakeEngine)
    browser = Browser.signed_in(app.address)
    with browser.stream() as events:
        events.next()
        start = RunStart(link="sim", world="w", world_document={}, seed=0, app_version="1")
        run = app._store.runs.begin(start)
        for tick in range(45):
            engine.send(sample(run.id, tick))
        start_s = time.perf_counter()
        app.close()
        elapsed_s = time.perf_counter() - start_s
    print(f"closing with a stream and a run took {elapsed_s:.3f} s")
    assert elapsed_s < CLOSE_LIMIT_S
    with open_store(database) as store:
        assert store.runs.get(run.id).reason == "interrupted"
        assert len(store.runs.telemetry(run.id).rows) == 45


def test_after_closing_nothing_of_the_app_is_left(
    database: Path, start_app: Callable[..., App]
) -> None:
    before = set(threading.enumerate())
    app = start_app()
    run = app._store.runs.begin(
        RunStart(link="sim", world="w", world_document={}, seed=0, app_version="1")
    )
    app._on_engine_event(ended(run.id, 0, 0))
    address = app.address
    app.close()
    app.close()
    assert {thread for thread in set(threading.enumerate()) - before if not thread.daemon} == set()
    with pytest.raises(ConnectionError):
        Browser.at(address).get("/")
    assert sorted(path.name for path in database.parent.iterdir()) in (
        ["backups", "pinel.db", "pinel.db.mark.json"],
        ["backups", "pinel.db", "pinel.db.mark.json", "pinel.lock"],
    )


def test_a_disk_that_is_nearly_full_is_said_while_everything_is_still_being_saved(
    start_app: Callable[..., App], monkeypatch: pytest.MonkeyPatch
) -> None:
    room = [300 * 10**6]
    monkeypatch.setattr("shutil.disk_usage", lambda folder: type("Usage", (), {"free": room[0]}))
    app = start_app()
    found = status_of(app)["database"]
    assert (found["writable"], found["notice"]["code"]) == (True, "disk_nearly_full")
    browser = Browser.signed_in(app.address)
    with browser.stream() as events:
        events.next()
        room[0] = 10**12
        app._maintenance.check_space()
        assert events.next()["code"] == "keeping_well_again"
    assert status_of(app)["database"]["notice"] is None


def test_a_backup_that_took_the_place_of_a_damaged_file_is_said_and_can_be_written(
    database: Path, start_app: Callable[..., App]
) -> None:
    with open_store(database) as store:
        store.groups.create("A")
        make_backup(database, datetime.now(UTC))
    database.write_bytes(b"no database at all " * 500)
    app = start_app()
    found = status_of(app)["database"]
    assert (found["writable"], found["notice"]["code"]) == (True, "database_restored")
    assert [group.name for group in app._store.groups.all()] == ["A"]


def test_a_file_that_another_program_holds_too_long_is_said_in_words_and_free_again_later(
    database: Path, start_app: Callable[..., App]
) -> None:
    app = start_app()
    browser = Browser.signed_in(app.address)
    app._store._database.submit(
        lambda db: db.execute("PRAGMA busy_timeout = 50").fetchone()
    ).result()
    with closing(sqlite3.connect(database, isolation_level=None)) as other:
        other.execute("BEGIN EXCLUSIVE")
        answer = browser.post("/api/groups", {"name": "A"})
        other.execute("ROLLBACK")
    assert (answer.status, answer.error["code"]) == (503, "database_locked")
    assert answer.error["message"]
    assert str(database) in answer.error["remedy"]
    assert browser.post("/api/groups", {"name": "A"}).status == 200
