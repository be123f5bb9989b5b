"""`pinel calibrate RUN...`: what recorded runs tell about a real robot."""

import json
from typing import TYPE_CHECKING

import click

from pinel_desktop.commands.database import opened_for_reading, opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.runs import find_run

if TYPE_CHECKING:
    from collections.abc import Iterator

    from pinel_desktop.calibration.report import CalibrationReport, ReportedParameter


@click.command()
@database_option
@click.argument("runs", metavar="RUN...", nargs=-1, required=True)
@click.option("--name", help="Store the robot under this name, for the simulator.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.pass_context
def command(ctx: click.Context, runs: tuple[str, ...], name: str | None, as_json: bool) -> None:
    """Learn the errors of a real robot from its runs.

    RUN is the id of a run, or a unique prefix of it. Wheels, track and slip need runs whose true pose was measured:
    docs/calibration.md.
    """
    from pinel_desktop.calibration.recorded import calibrate_runs  # noqa: PLC0415 - imports numpy

    path = chosen_database(ctx)
    with opened_store(path, may_be_new=False) if name else opened_for_reading(path) as store:
        report = calibrate_runs(store, [find_run(store, run) for run in dict.fromkeys(runs)])
        if name is not None:
            store.calibrated_robots.create(name, report.model, report.values, report.as_record())
    click.echo(json.dumps(report.as_record()) if as_json else "\n".join(_lines(report)))


def _lines(report: "CalibrationReport") -> "Iterator[str]":
    yield f"{'parameter':<18}{'value':>9}  {'95 % interval':<20}{'nominal':>9}  source"
    yield from map(_line, report.parameters)
    for one in report.held_out:
        yield (
            f"{report.runs[one.place]}  predicted by the others to {one.error_m * 100:.1f} cm"
            f" (noise floor {one.expected_m * 100:.1f} cm, not calibrated {one.nominal_m * 100:.1f} cm)"
        )
    if not report.held_out:
        yield "no run was held out: only a run that others are like can be predicted by them; drive each program again"
    if squares := report.squares:
        yield (
            f"UMBmark: wheels differ by {squares.difference * 100:.2f} %, track is {squares.track_ratio:.4f} of the"
            f" nominal one, E_max,syst {squares.worst_m * 100:.1f} cm"
        )
        if squares.left_over_m is not None:
            yield f"UMBmark: with the calibrated robot {squares.left_over_m * 100:.1f} cm of E_max,syst are left"


def _line(one: "ReportedParameter") -> str:
    if not one.is_known:
        return f"{one.name:<18}{'-':>9}  {'these runs do not tell':<20}{one.nominal:>7.4f}"
    interval = "" if one.low == one.high else f"{one.low:.4f} to {one.high:.4f}"
    return f"{one.name:<18}{one.value:>9.4f}  {interval:<20}{one.nominal:>9.4f}  {', '.join(one.sources)}"
