"""`pinel judge`: the process that judges runs of activities, started by the app."""

import click

from pinel_desktop.commands.owned.pipe import pipes
from pinel_desktop.judge.server import Judge


@click.command(hidden=True)
def command() -> None:
    """Judge programs for the app: requests on standard input, verdicts on standard output."""
    with pipes("judge") as (questions, verdicts):
        Judge(questions, verdicts).serve()
