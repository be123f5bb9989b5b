"""`pinel doctor`: prints the diagnosis of this PC."""

import json
from typing import Any

import click

from pinel_desktop import __version__
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.doctor.examination import HealthCheckResult, Level, examine
from pinel_desktop.messages import describe, explain, language_of_system

_COLOURS: dict[Level, str] = {"ok": "green", "warn": "yellow", "fail": "red"}


@click.command()
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@database_option
@click.pass_context
def command(ctx: click.Context, as_json: bool) -> None:
    """Diagnose this PC: report the requirements of PINEL, and which of them are missing.

    Exit status: 0 if PINEL can work here, 1 if something necessary is missing.
    """
    language = language_of_system()
    if not as_json:
        click.echo(describe("doctor_title", {"version": __version__}, language).message)
    findings = []
    for finding in examine(chosen_database(ctx)):
        findings.append(finding)
        if not as_json:
            _print(finding, language)
    failed = any(finding.level == "fail" for finding in findings)
    if as_json:
        lines = [_as_object(finding, language) for finding in findings]
        click.echo(
            json.dumps(
                {"ok": not failed, "version": __version__, "findings": lines}, ensure_ascii=False
            )
        )
    else:
        click.echo(describe(_verdict(findings), {}, language).message)
    ctx.exit(int(failed))


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
