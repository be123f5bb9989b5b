"""Options of commands that run much: on processes of this PC, or on a Dask cluster."""

from collections.abc import Callable
from typing import Any

import click

from pinel_desktop.processes.workers import Workers


def worker_options(*old_names: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Adds the options of `chosen_workers`.

    Args:
        old_names: what `--workers` was called in earlier releases.
    """
    workers = click.option(
        "--workers",
        *old_names,
        "workers",
        type=click.IntRange(1, 256),
        help="Number of parallel processes; one per core by default.",
    )
    dask = click.option(
        "--dask",
        metavar="tcp://HOST:PORT",
        help="Scheduler of a Dask cluster that does the work instead (docs/district.md).",
    )
    return lambda command: workers(dask(command))


def chosen_workers(workers: int | None, dask: str | None) -> Workers:
    """Returns the choice. Raises click.UsageError for both options."""
    if workers is not None and dask is not None:
        raise click.UsageError("--workers and --dask cannot be combined")
    return Workers(workers, dask)
