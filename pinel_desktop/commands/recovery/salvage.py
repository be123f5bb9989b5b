"""`pinel salvage`: salvages the readable rows of a damaged file."""

import json
from dataclasses import asdict
from pathlib import Path

import click

from pinel_desktop.commands.database import opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.printing import Failure
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from storage import StoreError


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@database_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.pass_context
def command(ctx: click.Context, file: Path, as_json: bool) -> None:
    """Salvage the readable rows of a damaged file. FILE is a file that PINEL set aside, or a backup.

    FILE is only read. Existing work stays; of two states of the same work, the later one wins. Close PINEL first.
    """
    if not file.is_file():
        raise Failure(PinelError("salvage_missing", file=str(file)))
    with opened_store(chosen_database(ctx), may_be_new=True) as store:
        try:
            salvaged = store.salvage(file)
        except StoreError as error:
            raise Failure(error) from error
        except Exception as error:  # a damaged file may have any content
            problem = str(error) or type(error).__name__
            raise Failure(PinelError("salvage_failed", file=str(file), problem=problem)) from error
    if as_json:
        click.echo(json.dumps(asdict(salvaged)))
        return
    code = "salvaged" if salvaged.n_rows else "salvage_nothing"
    text = describe(code, {"file": str(file), **asdict(salvaged)}, language_of_system())
    click.echo("\n".join(filter(None, (text.message, text.remedy))))
