"""`pinel window`: briefly opens the window on a small page, started by `pinel doctor`."""

import json

import click

from pinel_desktop.desktop.backends import NoWindowError, Toolkit
from pinel_desktop.desktop.ending import end_process
from pinel_desktop.desktop.trial import show_page


@click.command(hidden=True)
@click.argument("toolkit")
@click.argument("timeout_s", type=float)
def command(toolkit: Toolkit, timeout_s: float) -> None:
    """Try the window for the doctor: status 0, or a JSON object with the reason on standard output."""
    status = 0
    try:
        show_page(toolkit, timeout_s)
    except NoWindowError as problem:
        click.echo(json.dumps({"code": problem.code, "params": problem.params}))
        status = 1
    end_process(status)
    raise SystemExit(status)
