"""Options shared by several commands."""

from pathlib import Path

import click

from pinel_desktop.paths import database_path


def _store_choice(ctx: click.Context, _option: click.Parameter, file: str | None) -> None:
    if file is not None:
        ctx.ensure_object(dict)["db"] = file


recognizer_option = click.option(
    "--recognizer",
    metavar="NAME",
    help="What reads the signs: landmarks (the default), or yolo:FILE for a detector (.onnx, .pt).",
)

# accepted before and after the subcommand; the latter takes precedence
database_option = click.option(
    "--db",
    type=click.Path(dir_okay=False),
    expose_value=False,
    callback=_store_choice,
    help="Database file instead of the user's own.",
)


def chosen_file(ctx: click.Context) -> str | None:
    """Returns the value of `--db`; None for the user's own database."""
    file: str | None = ctx.ensure_object(dict).get("db")
    return file


def chosen_database(ctx: click.Context) -> Path:
    """Returns the path of the database for the command."""
    return database_path(chosen_file(ctx))
