"""Options that several commands share."""

from pathlib import Path

import click

from pinel_desktop.paths import database_path


def _keep(ctx: click.Context, _option: click.Parameter, file: str | None) -> None:
    if file is not None:
        ctx.ensure_object(dict)["db"] = file


# may stand before the subcommand or after it; the later one counts
database_option = click.option(
    "--db",
    type=click.Path(dir_okay=False),
    expose_value=False,
    callback=_keep,
    help="Database file instead of the user's own.",
)


def chosen_file(ctx: click.Context) -> str | None:
    """The file of `--db`, None where the user's own is meant."""
    file: str | None = ctx.ensure_object(dict).get("db")
    return file


def chosen_database(ctx: click.Context) -> Path:
    """The database that the command works on."""
    return database_path(chosen_file(ctx))
