"""`pinel cloud`: the process that drives a program in many robots at once, started by the app."""

import click

from pinel_desktop.cloud.server import CloudServer
from pinel_desktop.commands.owned.pipe import pipes


@click.command(hidden=True)
def command() -> None:
    """Drive programs in many robots for the app: requests on standard input, rows on standard output."""
    with pipes("cloud") as (requests, rows):
        CloudServer(requests, rows).serve()
