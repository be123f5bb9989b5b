"""`pinel check ACTIVITY FILE...`: checks in parallel whether programs pass an activity."""

import json
import sys
from dataclasses import asdict
from typing import Any

import click

from pinel_desktop.activities import (
    Activity,
    ActivityError,
    Report,
    check_files,
    choose_activity,
)
from pinel_desktop.commands.batch.workers import chosen_workers, worker_options
from pinel_desktop.commands.printing import print_problem
from pinel_desktop.commands.program_file import location_of, print_faults
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, explain, language_of_system
from pinel_desktop.processes.workers import Workers

_MAX_FAULTS = 5
_MAX_FAULTS_OF_ACTIVITY = 50
_PASSED, _NOT_PASSED, _UNUSABLE, _INTERRUPTED = 0, 1, 2, 130


@click.command()
@click.argument("activity")
@click.argument("files", metavar="FILE...", nargs=-1, required=True)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object per program.")
@worker_options("--processes")
@click.pass_context
def command(
    ctx: click.Context,
    activity: str,
    files: tuple[str, ...],
    as_json: bool,
    workers: int | None,
    dask: str | None,
) -> None:
    """Check whether programs pass an activity.

    ACTIVITY is the name of a shipped activity, or a file (.json). FILE is a program document, a bare list or Python
    text. Exit status: 0 all pass, 1 not all pass, 2 the activity cannot be used, 130 ended by Ctrl-C; the reports that
    were ready are then printed.
    """
    language = language_of_system()
    chosen = chosen_workers(workers, dask)
    try:
        reports, is_whole = _checked(choose_activity(activity), files, chosen)
    except PinelError as error:
        _print_error(error, language)
        ctx.exit(_UNUSABLE)
    for report in reports:
        if as_json:
            click.echo(json.dumps(_as_object(report, language), ensure_ascii=False))
        else:
            click.echo("\n".join(_lines(report, language)))
    n_passed = sum(report.passed for report in reports)
    if not as_json:
        click.echo(f"{n_passed}/{len(reports)}")
    if not is_whole:
        interrupted = PinelError("check_interrupted", done=len(reports), of=len(files))
        print_problem(interrupted, language)
        ctx.exit(_INTERRUPTED)
    ctx.exit(_PASSED if n_passed == len(reports) else _NOT_PASSED)


def _print_error(error: PinelError, language: str) -> None:
    print_problem(error, language)
    if isinstance(error, ActivityError):
        print_faults(error.faults[:_MAX_FAULTS_OF_ACTIVITY], language)


def _checked(
    activity: Activity, files: tuple[str, ...], workers: Workers
) -> tuple[list[Report], bool]:
    """Returns the reports in the order of the files, and whether they are complete. Prints the progress to stderr."""
    reports: dict[int, Report] = {}
    with click.progressbar(length=len(files), file=sys.stderr) as progress:
        try:
            for i, report in check_files(activity, files, workers):
                reports[i] = report
                progress.update(1)
        except KeyboardInterrupt:
            pass  # the finished reports are still printed
    return [reports[i] for i in sorted(reports)], len(reports) == len(files)


def _as_object(report: Report, language: str) -> dict[str, Any]:
    found = asdict(report)
    for fault in found["faults"]:
        fault["message"] = describe(fault["code"], fault["params"], language).message
    for case in found["cases"]:
        reason = case["reason"]
        case["message"] = describe(reason, case["params"], language).message if reason else None
        for check in case["checks"]:
            check["message"] = check.pop("words").get(language)
        case["advice"] = case["advice"] and _in_language(case["advice"], language)
    advice = report.advice and _in_language(asdict(report.advice), language)
    return {"program": report.program, "passed": report.passed, "advice": advice, **found}


def _in_language(advice: dict[str, Any], language: str) -> dict[str, Any]:
    return {**advice, "words": advice["words"][language]}


def _lines(report: Report, language: str) -> list[str]:
    """Returns the report of one program as lines of text, with failed checks only."""
    lines = [f"{'+' if report.passed else '-'} {report.program}"]
    for fault in report.faults[:_MAX_FAULTS]:
        place = location_of(fault.pointer, fault.params, language)
        lines.append(f"    {place}: {explain(fault, language).line}")
    if len(report.faults) > _MAX_FAULTS:
        lines.append(f"    … (+{len(report.faults) - _MAX_FAULTS})")
    for i, case in enumerate(report.cases):
        where = f"{i + 1}. " if len(report.cases) > 1 else ""
        lines += [f"    {where}{one.words[language]}" for one in case.checks if not one.holds]
    if report.advice is not None:
        lines.append(f"    > {report.advice.words[language]}")
    return lines
