"""`pinel runs verify --all`: verifies all runs of a store, on any workers."""

import hashlib
import json
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

import click

from pinel_desktop.commands.batch.journal import Journal, journal_path, unwritable
from pinel_desktop.commands.printing import print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import explain, language_of_system
from pinel_desktop.processes.pool import ProcessDied
from pinel_desktop.processes.versions import versions
from pinel_desktop.processes.workers import Workers, results_of
from pinel_desktop.program.faults import Fault
from pinel_desktop.runs.verification import (
    RecordedRun,
    VerificationResult,
    recorded_run,
    verify_recorded,
)
from storage import Store, StoreError
from storage.file.atomic_files import atomic_write

_GOOD = ("identical", "equal")
# runs that nothing is wrong with, but that cannot be repeated
_NOT_REPEATED = ("run_not_simulated", "run_not_ended", "run_not_repeatable")
_FINE, _NOT_FINE, _UNUSABLE, _INTERRUPTED = 0, 1, 2, 130
_ATTEMPTS = 2

Found = VerificationResult | Fault
Line = dict[str, Any]


class _Task(NamedTuple):
    """A run to verify, with everything that the store holds of it."""

    id: str
    run: RecordedRun


class _Lines:
    """What is found of each run (`found`, by id); with a result file also on disk, so that a kill costs one run.

    Raises PinelError `sweep_exists`, `sweep_other`, `sweep_unwritable`.
    """

    def __init__(self, store: Store, out: Path | None) -> None:
        self._language = language_of_system()
        self._journal = _journal(store, out) if out else None
        done = self._journal.rows if self._journal else {}
        # what could not be verified is tried again: it may have ended meanwhile
        self.found = {run: line for run, line in done.items() if line["outcome"]}

    def add(self, run_id: str, found: Found) -> None:
        line = _as_object(run_id, found, self._language)
        if self._journal:
            self._journal.add(line)
        self.found[run_id] = line

    def end(self, out: Path | None, lines: Sequence[Line]) -> None:
        """Writes the complete result in place of the unfinished one. Raises PinelError `sweep_unwritable`."""
        if out is None or self._journal is None:
            return
        try:
            with atomic_write(out) as part:
                part.write_text("".join(f"{_json(line)}\n" for line in lines), "utf-8")
        except OSError as error:
            raise unwritable(out, error) from error
        self._journal.delete()

    def close(self) -> None:
        if self._journal:
            self._journal.close()


def verify_all(store: Store, workers: Workers, *, as_json: bool, out: Path | None = None) -> int:
    """Verifies all runs, prints them in the order of their ids, and returns the exit status.

    Args:
        out: a new file for the lines, which are then not printed. The same call goes on after a kill.
    """
    language, ids = language_of_system(), store.runs.ids()
    status = _FINE
    try:
        every = _Lines(store, out)
    except PinelError as error:
        print_problem(error, language)
        return _UNUSABLE
    try:
        _verify_rest(store, ids, every, workers)
        every.end(out, _in_order(every, ids))
    except KeyboardInterrupt:
        status = _INTERRUPTED
    except PinelError as error:  # a cluster, a full disk
        print_problem(error, language)
        status = _UNUSABLE
    finally:
        every.close()
    lines = _in_order(every, ids)
    _print(lines, as_json=as_json, is_listed=out is None)
    if status:
        print_problem(_unfinished(len(lines), len(ids), out), language)
    elif any(_outcome(line) not in (*_GOOD, *_NOT_REPEATED) for line in lines):
        status = _NOT_FINE
    return status


def _journal(store: Store, out: Path) -> Journal[str, Line]:
    if out.exists():
        raise PinelError("sweep_exists", path=str(out))
    work = json.dumps(["verify", str(store.path.resolve()), versions()], sort_keys=True)
    return Journal(journal_path(out), hashlib.sha256(work.encode()).hexdigest(), _line_from)


def _line_from(plain: Line) -> tuple[str, Line]:
    if not isinstance(plain, dict) or not {"run", "outcome", "reason"} <= plain.keys():
        raise ValueError("no line")
    return str(plain["run"]), plain


def _verify_rest(store: Store, ids: Sequence[str], every: _Lines, workers: Workers) -> None:
    """Verifies what is not found yet. Prints the progress to stderr."""
    rest = [run_id for run_id in ids if run_id not in every.found]
    with click.progressbar(length=len(ids), file=sys.stderr) as progress:
        progress.update(len(ids) - len(rest))
        for run_id, result in _verified(store, rest, workers):
            every.add(run_id, result)
            progress.update(1)


def _in_order(every: _Lines, ids: Sequence[str]) -> list[Line]:
    return [every.found[run_id] for run_id in sorted(ids) if run_id in every.found]


def _print(lines: Sequence[Line], *, as_json: bool, is_listed: bool) -> None:
    for line in lines if is_listed else ():
        click.echo(_json(line) if as_json else _line(line))
    if not as_json:
        counts = Counter(_outcome(line) for line in lines)
        click.echo(", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items())))


def _unfinished(done: int, of: int, out: Path | None) -> PinelError:
    if out is None:
        return PinelError("verify_interrupted", done=done, of=of)
    return PinelError("sweep_unfinished", done=done, of=of, path=str(journal_path(out)))


def _verified(store: Store, ids: Sequence[str], workers: Workers) -> Iterator[tuple[str, Found]]:
    """Yields the runs in order of completion. Reads a run when a worker is free."""
    unreadable: list[tuple[str, Found]] = []

    def tasks() -> Iterator[_Task]:
        for run_id in ids:
            try:
                yield _Task(run_id, recorded_run(store, store.runs.get(run_id)))
            except (PinelError, StoreError) as error:
                unreadable.append((run_id, Fault(error.code, params=dict(error.params))))

    for task, result in results_of(_verify, tasks(), workers, attempts=_ATTEMPTS):
        yield task.id, _lost(result) if isinstance(result, ProcessDied) else result
    yield from unreadable


def _verify(task: _Task) -> Found:
    try:
        return verify_recorded(task.run)
    except (PinelError, StoreError) as error:
        return Fault(error.code, params=dict(error.params))
    except Exception as error:
        # a record that PINEL cannot repeat must not end the verification of the others
        detail = f"{type(error).__name__}: {error}"
        return Fault("internal_error", params={"detail": detail})


def _lost(died: ProcessDied) -> Fault:
    return Fault("worker_lost", params={"value": died.exit_code})


def _outcome(line: Line) -> str:
    return str(line["outcome"] or line["reason"])


def _as_object(run_id: str, found: Found, language: str) -> Line:
    if isinstance(found, Fault):
        text = explain(found, language)
        return {"run": run_id, "outcome": None, "reason": found.code, "message": text.line}
    return {"run": run_id, "reason": None, **asdict(found)}


def _json(line: Line) -> str:
    return json.dumps(line, ensure_ascii=False)


def _line(line: Line) -> str:
    return f"{line['run']}  {line['outcome'] or line['message']}"
