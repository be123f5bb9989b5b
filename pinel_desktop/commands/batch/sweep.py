"""`pinel sweep PROGRAM...`: runs programs with many seeds, and writes a table with a line for each run."""

import json
import sys
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Any

import click

from pinel_desktop.commands.batch.journal import Journal, plain_of, sweep_journal
from pinel_desktop.commands.batch.summary import summary_lines, summary_object
from pinel_desktop.commands.batch.sweep_plan import SweepPlan, planned
from pinel_desktop.commands.batch.table import require_new_table, write_table
from pinel_desktop.commands.batch.workers import chosen_workers, worker_options
from pinel_desktop.commands.printing import print_problem
from pinel_desktop.commands.program_file import print_faults
from pinel_desktop.commands.typed_inputs import input_options
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import language_of_system
from pinel_desktop.processes.workers import Workers
from pinel_desktop.robot import FEEDBACKS, PRESETS, ROBOTS
from pinel_desktop.sweep import Row, run_jobs
from storage import StoreError

_MAX_SEEDS = 1_000_000
_MAX_FAULTS = 50
_UNUSABLE, _UNFINISHED, _INTERRUPTED = 2, 1, 130


def _plan_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Adds the options that say which runs there are."""
    for add in (
        click.option(
            "--vary",
            metavar="NAME=LOW:HIGH",
            multiple=True,
            help="Draw a parameter of the robot for each seed, such as track_m=0.32:0.34 (docs/sweep.md).",
        ),
        click.option(
            "--set",
            "parameters",
            metavar="NAME=VALUE",
            multiple=True,
            help="A parameter of the robot in all runs, such as track_m=0.33 (docs/sweep.md).",
        ),
        click.option(
            "--feedback",
            type=click.Choice(FEEDBACKS),
            help="How the robot knows where it is, as in `pinel run`.  [default: pose, or the activity's]",
        ),
        click.option(
            "--preset",
            type=click.Choice(PRESETS),
            default="realistic",
            show_default=True,
            help="Noise, slip and latency of the simulator.",
        ),
        click.option(
            "--robot",
            type=click.Choice(list(ROBOTS)),
            help="Robot in the simulator.  [default: pioneer_3dx, or the activity's]",
        ),
        click.option(
            "--seeds",
            type=click.IntRange(1, _MAX_SEEDS),
            required=True,
            help="How many runs each program has in each world: with the seeds 0, 1, 2 and so on.",
        ),
        click.option(
            "--world",
            "worlds",
            metavar="NAME|FILE",
            multiple=True,
            help="World of the simulator, as in `pinel run`; may be given several times.  "
            "[default: empty_room, or the activity's]",
        ),
        click.option(
            "--activity", metavar="NAME|FILE", help="Judge each run by the checks of this activity."
        ),
    ):
        command = add(command)
    return command


@click.command()
@click.argument("programs", metavar="PROGRAM...", nargs=-1, required=True)
@_plan_options
@input_options
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    required=True,
    help="New file for the table, .csv or .parquet.",
)
@worker_options()
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.pass_context
def command(
    ctx: click.Context,
    /,
    out: Path,
    workers: int | None,
    dask: str | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Run programs with many seeds: how firm are they?

    PROGRAM is a program document, a bare list of commands, or Python text. Writes a table with a line for each run, in
    the same order whatever runs them, and prints a summary. The same command goes on after a kill or a full disk. Exit
    status: 0 done, 1 begun but not done, 2 nothing can be run, 130 ended by Ctrl-C.
    """
    language = language_of_system()
    chosen = chosen_workers(workers, dask)
    try:
        require_new_table(out)
        plan = planned(**options)
        journal = sweep_journal(out, plan.fingerprint)
    except (PinelError, StoreError) as error:
        _print(error, language)
        ctx.exit(_UNUSABLE)
    try:
        _run(plan, journal, chosen)
        write_table(out, journal.rows.values(), plan.ranges)
    except (PinelError, KeyboardInterrupt) as error:
        if isinstance(error, PinelError):
            _print(error, language)
        ctx.exit(_end_unfinished(plan, journal, error, language))
    journal.delete()
    rows = list(journal.rows.values())
    if as_json:
        click.echo(json.dumps(summary_object(rows), ensure_ascii=False))
    else:
        click.echo("\n".join(summary_lines(rows)))


def _end_unfinished(
    plan: SweepPlan,
    journal: Journal[int, Row],
    error: PinelError | KeyboardInterrupt,
    language: str,
) -> int:
    """Says how to go on, and returns the exit status."""
    if not journal.rows:
        journal.delete()
        return _UNUSABLE if isinstance(error, PinelError) else _INTERRUPTED
    journal.close()
    rest = {"done": len(journal.rows), "of": plan.n_runs, "path": str(journal.path)}
    print_problem(PinelError("sweep_unfinished", **rest), language)
    return _UNFINISHED if isinstance(error, PinelError) else _INTERRUPTED


def _run(plan: SweepPlan, journal: Journal[int, Row], workers: Workers) -> None:
    """Runs what the journal lacks. Prints the progress to stderr."""
    if len(journal.rows) == plan.n_runs:
        return
    jobs = (job for job in plan.jobs() if job.index not in journal.rows)
    with (
        click.progressbar(length=plan.n_runs, file=sys.stderr) as progress,
        closing(run_jobs(jobs, workers)) as rows,
    ):
        progress.update(len(journal.rows))
        for row in rows:
            journal.add(plain_of(row))
            progress.update(1)


def _print(error: PinelError | StoreError, language: str) -> None:
    print_problem(error, language)
    print_faults(tuple(getattr(error, "faults", ()))[:_MAX_FAULTS], language)
