"""`pinel doctor`: prints the diagnosis of this PC."""

import json
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any

import click

from pinel_desktop import __version__
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.pc import first_start
from pinel_desktop.commands.printing import Failure
from pinel_desktop.doctor.examination import HealthCheckResult, Level, examine
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, explain, language_of_system
from pinel_desktop.school.pc_setup import PcSetupError, read_pc_setup

_COLOURS: dict[Level, str] = {"ok": "green", "warn": "yellow", "fail": "red"}


@click.command()
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.option(
    "--report",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Also write a report for support, without the pupils' work and names.",
)
@database_option
@click.pass_context
def command(ctx: click.Context, as_json: bool, report: Path | None) -> None:
    """Diagnose this PC: report the requirements of PINEL, and which of them are missing.

    Exit status: 0 if PINEL can work here, 1 if something necessary is missing.
    """
    language = language_of_system()
    if not as_json:
        click.echo(describe("doctor_title", {"version": __version__}, language).message)
    database = chosen_database(ctx)
    findings = []
    for finding in chain(examine(database), _set_up()):
        findings.append(finding)
        if not as_json:
            _print(finding, language)
    lines = [_as_object(finding, language) for finding in findings]
    if report is not None:
        _write_report(report, database, lines)
    failed = any(finding.level == "fail" for finding in findings)
    if as_json:
        click.echo(
            json.dumps(
                {"ok": not failed, "version": __version__, "findings": lines}, ensure_ascii=False
            )
        )
    else:
        click.echo(describe(_verdict(findings), {}, language).message)
    ctx.exit(int(failed))


def _set_up() -> Iterator[HealthCheckResult]:
    """Yields the faults of the set-up file, without which the app starts all the same; nothing without such a file."""
    if not first_start.SETUP_FILE.is_file():
        return
    try:
        read_pc_setup(first_start.SETUP_FILE)
    except PcSetupError as error:
        for fault in error.faults:
            yield HealthCheckResult("setup", "warn", fault.code, fault.params)
    else:
        path = {"path": str(first_start.SETUP_FILE)}
        yield HealthCheckResult("setup", "ok", "doctor_setup_ok", path)


def _write_report(target: Path, database: Path, findings: list[dict[str, Any]]) -> None:
    from pinel_desktop.doctor.report import write_report  # noqa: PLC0415 - seldom

    try:
        write_report(target, database, findings)
    except OSError as error:
        raise Failure(PinelError("report_not_written", path=str(target))) from error
    text = describe("report_written", {"path": str(target)}, language_of_system())
    click.echo(text.line, err=True)


def _verdict(findings: list[HealthCheckResult]) -> str:
    levels = {finding.level for finding in findings}
    if "fail" in levels:
        return "doctor_failures"
    return "doctor_warnings" if "warn" in levels else "doctor_all_well"


def _print(finding: HealthCheckResult, language: str) -> None:
    text = explain(finding, language)
    level = describe(f"doctor_{finding.level}", {}, language).message
    click.echo(click.style(f"[{level}]", fg=_COLOURS[finding.level]) + f" {text.message}")
    if text.full_remedy:
        click.echo(f"    {text.full_remedy}")


def _as_object(finding: HealthCheckResult, language: str) -> dict[str, Any]:
    text = explain(finding, language)
    return {
        "about": finding.about,
        "level": finding.level,
        "code": finding.code,
        "message": text.message,
        "remedy": text.full_remedy,
        "params": dict(finding.params),
    }
