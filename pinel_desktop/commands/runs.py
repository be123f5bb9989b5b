"""`pinel runs`: lists, shows and verifies recorded runs."""

import json
import re
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from pinel_desktop.commands.batch.workers import chosen_workers, worker_options
from pinel_desktop.commands.database import opened_for_reading
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, explain, language_of_system
from storage import RunRow, Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.runs.verification import VerificationResult

_ID = re.compile(r"[0-9a-f-]+")
_METRICS = (
    ("program_name", "program"),
    ("link", "link"),
    ("world", "world"),
    ("seed", "seed"),
    ("started_at", "started"),
    ("ended_at", "ended"),
    ("duration_s", "duration_s"),
    ("n_executed", "n_executed"),
    ("path_length_m", "path_length_m"),
    ("closing_error_m", "closing_error_m"),
    ("estimated_closing_error_m", "estimated_closing_error_m"),
    ("telemetry_sha256", "telemetry_sha256"),
)


@click.group()
@database_option
def command() -> None:
    """List, show and verify recorded runs."""


@command.command("list")
@click.option(
    "--limit", type=click.IntRange(1, 1000), default=20, show_default=True, help="How many at most."
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object per line.")
@click.pass_context
def list_runs(ctx: click.Context, limit: int, as_json: bool) -> None:
    """List runs, newest first."""
    with opened_for_reading(chosen_database(ctx)) as store:
        rows = store.runs.newest(limit)
    for row in rows:
        click.echo(json.dumps(_as_object(row), ensure_ascii=False) if as_json else _line(row))


@command.command("show")
@click.argument("run")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.pass_context
def show_run(ctx: click.Context, run: str, as_json: bool) -> None:
    """Show one run. RUN is its id, or a unique prefix of it."""
    with opened_for_reading(chosen_database(ctx)) as store:
        row = find_run(store, run)
        n_events = len(store.runs.events(row.id))
    if as_json:
        click.echo(json.dumps({**_as_object(row), "n_events": n_events}, ensure_ascii=False))
        return
    click.echo(f"{row.id}  {row.state}")
    for line in _details(row):
        click.echo(line)


@command.command("verify")
@click.argument("run", required=False)
@click.option(
    "--all", "is_all", is_flag=True, help="Verify all runs of the simulator, oldest first."
)
@worker_options()
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object per run.")
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    help="With --all: new file for one JSON object per run; the same command goes on after a kill.",
)
@click.pass_context
def verify(
    ctx: click.Context,
    run: str | None,
    is_all: bool,
    workers: int | None,
    dask: str | None,
    as_json: bool,
    out: Path | None,
) -> None:
    """Repeat a recorded run and compare all recorded data.

    RUN is as for `show`. Exit status: 0 equal, 1 different, changed, or not repeatable; of all runs, 1 if one is
    different, changed or damaged, 2 if a cluster or the file cannot be used, 130 ended by Ctrl-C.
    """
    if (run is None) is not is_all:
        raise click.UsageError("give RUN or --all")
    if out and not is_all:
        raise click.UsageError("--out needs --all")
    chosen = chosen_workers(workers, dask)
    if run is not None:
        _verify_one(ctx, run, as_json)
    from pinel_desktop.commands.batch.verify_all import verify_all  # noqa: PLC0415 - imports the simulator

    with opened_for_reading(chosen_database(ctx)) as store:
        ctx.exit(verify_all(store, chosen, as_json=as_json, out=out))


def _verify_one(ctx: click.Context, run: str, as_json: bool) -> NoReturn:
    from pinel_desktop.runs.verification import verify_run  # noqa: PLC0415 - imports the simulator

    with opened_for_reading(chosen_database(ctx)) as store:
        row = find_run(store, run)
        verdict = verify_run(store, row)
    if as_json:
        click.echo(json.dumps({"run": row.id, **asdict(verdict)}))
    else:
        code, params = _as_text(verdict, row)
        language = language_of_system()
        text = describe(code, params, language)
        click.echo(f"{row.id}  {verdict.outcome}\n{text.message}")
        for part in verdict.parts:
            click.echo(f"- {explain(part, language).message}")
        click.echo(text.full_remedy)
    ctx.exit(1 if verdict.outcome in ("different", "altered") else 0)


def _as_text(verdict: "VerificationResult", row: RunRow) -> tuple[str, dict[str, Any]]:
    first = verdict.difference
    if verdict.outcome == "equal" and not verdict.whole:
        return "verified_cut_off", {"ticks": verdict.n_ticks}
    if verdict.outcome != "different" or first is None:
        return f"verified_{verdict.outcome}", {"ticks": verdict.n_ticks}
    return "verified_different", {
        "tick": first.tick,
        "time": round(first.time_s, 2),
        "column": first.column,
        "recorded": round(first.recorded, 5),
        "repeated": round(first.repeated, 5),
        "version": row.app_version,
    }


def find_run(store: Store, run: str) -> RunRow:
    """Returns the run with this id or unique prefix. Raises StoreError `run_not_found`, PinelError `run_ambiguous`."""
    prefix = run.strip().lower()
    ids = store.runs.ids_beginning_with(prefix) if _ID.fullmatch(prefix) else []
    if not ids:
        raise StoreError("run_not_found", id=run)
    if len(ids) > 1 and prefix not in ids:
        raise PinelError("run_ambiguous", id=run, ids=ids)
    return store.runs.get(prefix if prefix in ids else ids[0])


def _as_object(row: RunRow) -> dict[str, Any]:
    text = describe(row.reason, row.params, language_of_system()) if row.reason else None
    return {
        **asdict(row),
        "estimated_closing_error_m": row.estimated_closing_error_m,
        "message": text and text.message,
        "remedy": text and text.full_remedy,
    }


def _line(row: RunRow) -> str:
    duration = "" if row.duration_s is None else f"{row.duration_s:.1f} s"
    ending = f"{row.state} {row.reason or ''}".strip()
    return (
        f"{row.id}  {row.started_at[:19]}  {ending:<22}  {duration:>8}  {row.program_name or '-'}"
    )


def _details(row: RunRow) -> list[str]:
    figures = {label: getattr(row, name) for name, label in _METRICS}
    # earlier releases recorded only the estimate, as `closing_error_m`
    if row.estimated_closing_error_m is None:
        figures["estimated_closing_error_m"] = figures.pop("closing_error_m")
    lines = [f"  {label}: {value}" for label, value in figures.items() if value is not None]
    if row.reason:
        text = describe(row.reason, row.params, language_of_system())
        lines.append(f"  {row.reason}: {text.line}")
    return lines
