"""The file with which a person opens PINEL, such as by a double click."""

import os
from pathlib import Path

import pytest

from pinel_desktop.errors import PinelError
from pinel_desktop.school.opened_file import OpenedFile, examined
from storage import StoreError, open_store
from storage.exchange import bundle_reading


@pytest.fixture
def bundle(tmp_path: Path) -> Path:
    with open_store(tmp_path / "pinel.db") as store:
        info = store.exchange.export(
            tmp_path / "trabalho.pinel", app_version="1", computer=store.computers.this()
        )
    return info.path


def refusal(path: Path) -> str:
    """Code and file name of the message about a file."""
    try:
        examined(path)
    except (PinelError, StoreError) as problem:
        return f"{problem.code} {Path(str(problem.params['path'])).name}"
    return "none"


def test_a_bundle_is_described(bundle: Path) -> None:
    assert examined(bundle).size_bytes == bundle.stat().st_size


@pytest.mark.parametrize(
    "name", ["\n; rm -rf ~ $(id).pinel", "-h.pinel", "ação 😀\u202e.pinel", "%n%f.pinel"]
)
def test_a_strange_name_is_a_name(bundle: Path, name: str) -> None:
    assert examined(bundle.rename(bundle.with_name(name))).path.name == name


def test_a_name_that_is_no_text_is_refused(tmp_path: Path) -> None:
    assert refusal(tmp_path / "caf\ufffd.pinel") == "opened_file_name caf\ufffd.pinel"


def test_a_missing_file_is_refused(tmp_path: Path) -> None:
    assert refusal(tmp_path / "gone.pinel") == "bundle_missing gone.pinel"
    name = f"{'long' * 100}.pinel"
    assert refusal(tmp_path / name) == f"bundle_unreadable {name}"


def test_a_link_a_pipe_and_a_folder_are_refused(bundle: Path, tmp_path: Path) -> None:
    link, pipe, folder = (tmp_path / f"{name}.pinel" for name in ("link", "pipe", "folder"))
    link.symlink_to(bundle)
    os.mkfifo(pipe)
    folder.mkdir()
    for path in (link, pipe, folder):
        assert refusal(path) == f"opened_file_irregular {path.name}"


def test_another_kind_of_file_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "foto.pinel"
    file.write_bytes(b"\x89PNG" + bytes(200))
    assert refusal(file) == "bundle_foreign foto.pinel"


def test_a_huge_file_is_refused_unread(tmp_path: Path) -> None:
    file = tmp_path / "huge.pinel"
    file.touch()
    os.truncate(file, bundle_reading._MAX_BYTES + 1)
    assert refusal(file) == "bundle_too_large huge.pinel"


def test_a_page_that_connects_after_the_start_is_led_to_the_file_once() -> None:
    opened = OpenedFile(lambda event: None, "/stick/a.pinel")
    assert [event["type"] for event in opened.news()] == ["file_opened"]
    assert opened.news() == []
    assert OpenedFile(lambda event: None).news() == []


def test_an_open_app_leads_its_pages_to_another_file() -> None:
    published: list[str] = []
    opened = OpenedFile(lambda event: published.append(event["type"]))
    opened.choose("/stick/a.pinel")
    opened.choose("/stick/b.pinel")
    opened.forget(Path("/stick/a.pinel"))
    assert str(opened.path) == "/stick/b.pinel"
    opened.forget(Path("/stick/b.pinel"))
    assert str(opened.path) == "None"
    assert published == ["file_opened", "file_opened"]
