"""`pinel runs verify --all`: verifies all runs of a store, on any workers."""

import json
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict
from typing import Any, NamedTuple

import click

from pinel_desktop.commands.printing import print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import explain, language_of_system
from pinel_desktop.processes.pool import ProcessDied
from pinel_desktop.processes.workers import Workers, results_of
from pinel_desktop.program.faults import Fault
from pinel_desktop.runs.verification import (
    RecordedRun,
    VerificationResult,
    recorded_run,
    verify_recorded,
)
from storage import Store, StoreError

_GOOD = ("identical", "equal")
# runs that nothing is wrong with, but that cannot be repeated
_NOT_REPEATED = ("run_not_simulated", "run_not_ended", "run_not_repeatable")
_FINE, _NOT_FINE, _UNUSABLE, _INTERRUPTED = 0, 1, 2, 130
_ATTEMPTS = 2

Found = VerificationResult | Fault


class _Task(NamedTuple):
    """A run to verify, with everything that the store holds of it."""

    id: str
    run: RecordedRun


def verify_all(store: Store, workers: Workers, *, as_json: bool) -> int:
    """Verifies all runs, prints them in the order of their ids, and returns the exit status."""
    language = language_of_system()
    ids = store.runs.ids()
    found: dict[str, Found] = {}
    status = _FINE
    try:
        with click.progressbar(length=len(ids), file=sys.stderr) as progress:
            for run_id, result in _verified(store, ids, workers):
                found[run_id] = result
                progress.update(1)
    except KeyboardInterrupt:
        status = _INTERRUPTED
    except PinelError as error:  # a cluster
        print_problem(error, language)
        status = _UNUSABLE
    for run_id in sorted(found):
        one = _as_object(run_id, found[run_id], language)
        click.echo(json.dumps(one, ensure_ascii=False) if as_json else _line(one))
    if not as_json:
        counts = Counter(_outcome(one) for one in found.values())
        click.echo(", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items())))
    if status:
        print_problem(PinelError("verify_interrupted", done=len(found), of=len(ids)), language)
    elif any(_is_bad(one) for one in found.values()):
        status = _NOT_FINE
    return status


def _verified(store: Store, ids: list[str], workers: Workers) -> Iterator[tuple[str, Found]]:
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


def _outcome(found: Found) -> str:
    return found.code if isinstance(found, Fault) else found.outcome


def _is_bad(found: Found) -> bool:
    return _outcome(found) not in (*_GOOD, *_NOT_REPEATED)


def _as_object(run_id: str, found: Found, language: str) -> dict[str, Any]:
    if isinstance(found, Fault):
        text = explain(found, language)
        return {"run": run_id, "outcome": None, "reason": found.code, "message": text.line}
    return {"run": run_id, "reason": None, **asdict(found)}


def _line(one: dict[str, Any]) -> str:
    return f"{one['run']}  {one['outcome'] or one['message']}"
