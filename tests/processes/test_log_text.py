"""A log file may be read by support: its lines say what failed and where, without work and names of pupils."""

import json
import logging
from collections.abc import Callable
from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.processes.log_text import PlainFormatter, described
from storage import StoreError
from storage.sqlite import sqlite3

SECRET = "Joana"


def line(logger: str, text: str, *values: object, error: BaseException | None = None) -> str:
    trace = (type(error), error, error.__traceback__) if error else None
    record = logging.LogRecord(logger, logging.ERROR, "/src/code.py", 12, text, values, trace)
    return PlainFormatter().format(record)


def raised(action: Callable[[], object]) -> BaseException:
    try:
        action()
    except Exception as error:
        return error
    pytest.fail("nothing was raised")


def test_a_line_has_time_level_and_logger() -> None:
    written = line("storage.scrub", "%s damaged: %s, %s", "versions", True, 3)
    time, rest = written.split(" ", 1)
    assert rest == "ERROR storage.scrub: versions damaged: True, 3"
    assert time.endswith("Z")
    assert len(time) == len("2026-11-26T12:00:00Z")


@pytest.mark.parametrize(
    "value",
    [
        SECRET,
        f"/home/{SECRET.lower()}/x.db",
        Path(f"/media/{SECRET}.pinel"),
        {"name": SECRET},
        [SECRET],
        PinelError("group_exists", name=SECRET),
        StoreError("group_exists", name=SECRET),
        ValueError(SECRET),
        FileNotFoundError(2, "No such file or directory", f"/media/{SECRET}.pinel"),
        "01JDMK3Q6G8M0F9ZT5V2RA7XQH",
    ],
    ids=lambda value: type(value).__name__,
)
def test_what_a_person_may_have_written_is_left_out(value: object) -> None:
    written = line("pinel_desktop.web", "%s failed: %s", "GET", value)
    assert "GET failed: " in written
    assert SECRET.lower() not in written.lower()
    assert "01JDMK" not in written


def test_an_error_is_logged_by_its_code_or_the_message_of_the_system() -> None:
    assert described(PinelError("disk_full", path=SECRET)) == "PinelError: disk_full"
    assert described(OSError(28, "No space left on device", SECRET)) == (
        "OSError: 28 No space left on device"
    )
    assert described(raised(lambda: sqlite3.connect(":memory:").execute("SELECT x"))) == (
        "OperationalError: no such column: x"
    )
    assert described(raised(lambda: json.loads(SECRET))) == "JSONDecodeError"
    assert described(raised(lambda: {SECRET: 1}.pop(SECRET * 2))) == "KeyError"


def test_the_stack_names_places_in_the_code_from_the_package_on() -> None:
    def read() -> None:
        try:
            raise FileNotFoundError(2, "No such file or directory", SECRET)
        except OSError as error:
            raise StoreError("database_unreadable", path=SECRET) from error

    written = line("storage.file", "failed", error=raised(read)).splitlines()
    assert written[1] == "  FileNotFoundError: 2 No such file or directory"
    assert written[2].startswith("    processes/test_log_text.py:")
    assert "  StoreError: database_unreadable" in written
    assert SECRET not in "".join(written)


def test_errors_that_are_each_others_context_end() -> None:
    first, second = ValueError(), ValueError()
    first.__context__, second.__context__ = second, first
    assert line("storage", "failed", error=first).count("ValueError") == 2


def test_of_another_library_only_the_place_is_written() -> None:
    assert line("waitress", f"Exception while serving /{SECRET}").endswith("waitress: code.py:12")


def test_a_text_that_does_not_fit_its_values_is_written_as_it_is() -> None:
    assert line("storage", "%d rows", SECRET).endswith("storage: %d rows")
