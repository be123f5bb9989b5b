"""Files that another process has open when they are to be renamed or deleted, as Windows refuses it."""

from pathlib import Path

import pytest

from storage.file.open_files import delete, replace, retry

PAUSES_S = (0.01, 0.1, 0.5)


class OpenFile:
    """An action that is refused `n_refusals` times; `n_tries` counts."""

    def __init__(self, n_refusals: int) -> None:
        self._n_refusals = n_refusals
        self.n_tries = 0

    def __call__(self) -> None:
        self.n_tries += 1
        if self.n_tries <= self._n_refusals:
            raise PermissionError(f"try {self.n_tries}")


def test_an_action_is_tried_again_until_the_other_process_has_closed_the_file() -> None:
    slept: list[float] = []
    action = OpenFile(2)
    retry(action, PAUSES_S, slept.append)
    assert (action.n_tries, slept) == (3, [0.01, 0.1])


def test_an_action_that_is_refused_for_ever_fails_after_the_last_pause() -> None:
    slept: list[float] = []
    with pytest.raises(PermissionError, match="try 4"):
        retry(OpenFile(99), PAUSES_S, slept.append)
    assert slept == [0.01, 0.1, 0.5]


def test_another_error_is_not_repeated() -> None:
    slept: list[float] = []

    def fail() -> None:
        raise FileNotFoundError

    with pytest.raises(FileNotFoundError):
        retry(fail, PAUSES_S, slept.append)
    assert slept == []


def test_files_are_replaced_and_deleted(tmp_path: Path) -> None:
    new, old = tmp_path / "new", tmp_path / "old"
    new.write_text("new", "utf-8")
    old.write_text("old", "utf-8")
    replace(new, old)
    assert old.read_text("utf-8") == "new"
    delete(old)
    with pytest.raises(FileNotFoundError):
        delete(old)
    delete(old, missing_ok=True)
    assert list(tmp_path.iterdir()) == []
