"""The table of attacks, continued: several accounts on one PC, and home folders on a server."""

import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.attacks.accounts import (
    ANA,
    BIA,
    CLASS,
    homes,
    library_without_locks,
    make_home,
    session,
)

pytestmark = [
    pytest.mark.waits,
    pytest.mark.skipif(sys.platform == "win32", reason="accounts of Linux"),
]


@pytest.fixture
def home() -> Iterator[Path]:
    with homes() as folder:
        yield folder


def test_two_accounts_at_once_have_their_own_work(home: Path) -> None:
    ana, bia = make_home(home / "ana", ANA), make_home(home / "bia", BIA)
    with session(ANA, ana) as first, session(BIA, bia) as second:
        assert first.create("Onças") < 300
        assert second.create("Tucanos") < 300
        assert (first.groups, second.groups) == (["Onças"], ["Tucanos"])


@pytest.mark.parametrize("umask", [0o002, 0o022])
def test_a_folder_that_two_accounts_share_is_open_in_one_at_a_time(home: Path, umask: int) -> None:
    shared = make_home(home / "turma", ANA)
    os.chown(shared, ANA, CLASS)
    shared.chmod(0o2770)
    ana, bia = make_home(home / "ana", ANA), make_home(home / "bia", BIA)
    place = {"PINEL_HOME": str(shared)}
    with session(ANA, ana, umask, **place) as first:
        assert first.create("Onças") < 300
        with session(BIA, bia, umask, **place) as second:
            assert second.browser is None
            assert "already open" in second.output
    with session(BIA, bia, umask, **place) as second:
        assert second.groups == ["Onças"]
        assert second.create("Tucanos") < 300
    with session(ANA, ana, umask, **place) as first:
        assert sorted(first.groups) == ["Onças", "Tucanos"]
        assert first.create("Lobos") < 300


@pytest.mark.parametrize("locale", ["pt_BR.UTF-8", "C", "POSIX"])
def test_a_name_with_accents_and_spaces_is_a_home_like_any(home: Path, locale: str) -> None:
    folder = make_home(home / "joão da conceição ñ 李", ANA)
    with session(ANA, folder, LC_ALL=locale) as pinel:
        assert pinel.create("Onças") < 300
        assert pinel.groups == ["Onças"]
    assert (folder / ".local" / "share" / "pinel" / "pinel.db").is_file()


def test_a_home_in_which_only_root_may_write_is_reported(home: Path) -> None:
    folder = make_home(
        home / "ana", 0, mode=0o755
    )  # as a server that takes root's files for nobody's
    with session(ANA, folder) as pinel:
        assert pinel.notice == "database_read_only"
        assert pinel.groups == []
        assert pinel.create("Onças") >= 400


def test_a_home_that_grants_no_locks_is_reported_and_the_work_is_there_when_it_does(
    home: Path,
) -> None:
    library = library_without_locks(home)
    folder = make_home(home / "ana", ANA)
    with session(ANA, folder) as pinel:
        assert pinel.create("Onças") < 300
    with session(ANA, folder, LD_PRELOAD=str(library)) as pinel:
        assert pinel.notice == "database_locked_at_start"
        assert pinel.create("Tucanos") >= 400
    with session(ANA, folder) as pinel:
        assert pinel.groups == ["Onças"]
        assert pinel.notice != "database_locked_at_start"
