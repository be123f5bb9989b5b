"""`pinel python FILE`: prints a program as Python text, or as a document (docs/python-text.md)."""

import json

import click

from pinel_desktop.commands.program_file import print_faults, read_file
from pinel_desktop.messages import language_of_system
from pinel_desktop.program.python_text import write_python

_INVALID = 2


@click.command()
@click.argument("file", metavar="FILE")
@click.option("--json", "as_json", is_flag=True, help="Print the program document instead.")
@click.pass_context
def command(ctx: click.Context, file: str, as_json: bool) -> None:
    """Print a program as Python text.

    FILE is a program document, a bare list of commands, or Python text; - is standard input. Exit status: 0 printed,
    2 the program has faults or cannot be read.
    """
    language = language_of_system()
    reading = read_file(file)
    print_faults((*reading.warnings, *reading.faults), language)
    document = reading.document
    if document is None:
        ctx.exit(_INVALID)
    if as_json:
        click.echo(json.dumps(document, ensure_ascii=False, indent=2))
    else:
        click.echo(write_python(document).text, nl=False)
