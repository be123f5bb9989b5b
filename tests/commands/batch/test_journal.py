"""The journal of a sweep: what a kill tore costs one row, now and later."""

from pathlib import Path

import pytest

from pinel_desktop.commands.batch.journal import plain_of, sweep_journal
from pinel_desktop.errors import PinelError
from pinel_desktop.sweep import Row


def row(index: int) -> Row:
    return Row(index, "square.json", "empty_room", seed=index, end=(0.1, 0.2, 0.3))


def test_rows_after_a_torn_line_are_rows(tmp_path: Path) -> None:
    out, file = tmp_path / "runs.csv", tmp_path / "runs.csv.rows"
    for index in range(3):
        journal = sweep_journal(out, "a sweep")
        assert journal.rows == {earlier: row(earlier) for earlier in range(index)}
        journal.add(plain_of(row(index)))
        journal.close()
        with file.open("ab") as torn:
            torn.write(b'{"index": 9, "prog')


def test_torn_head_is_written_again_and_another_file_is_refused(tmp_path: Path) -> None:
    out, file = tmp_path / "runs.csv", tmp_path / "runs.csv.rows"
    file.write_bytes(b'{"pinel_sw')
    sweep_journal(out, "a sweep").close()
    assert file.read_bytes() == b'{"pinel_sweep": "a sweep"}\n'
    file.write_bytes(b"somebody's notes")
    with pytest.raises(PinelError) as caught:
        sweep_journal(out, "a sweep")
    assert (caught.value.code, file.read_bytes()) == ("sweep_other", b"somebody's notes")
