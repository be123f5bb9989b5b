"""`pinel export`: writes a bundle of all work, or a part of it, for other PCs."""

import json
import platform
import re
from dataclasses import asdict
from datetime import datetime
from pathlib import Path
from typing import Any

import click

from pinel_desktop import __version__
from pinel_desktop.activities.reading import shipped_texts
from pinel_desktop.commands.database import key_of, opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.messages import describe, language_of_system
from storage import Store, StoreError
from storage.exchange.bundle_writing import SUFFIX, BundleInfo
from storage.exchange.scope import Scope
from storage.text import new_id


@click.command()
@click.argument("dest", type=click.Path(path_type=Path))
@database_option
@click.option("--class", "classroom", help="Only this class (name or key).")
@click.option("--group", help="Only this group (name or key).")
@click.option("--program", help="Only this program (name or key).")
@click.option(
    "--anonymous",
    is_flag=True,
    help="Leave out all names and texts (docs/bundles.md lists what stays).",
)
@click.option("--parquet", is_flag=True, help="Write a folder of Parquet files (docs/parquet.md).")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.pass_context
def command(
    ctx: click.Context,
    /,
    dest: Path,
    anonymous: bool,
    parquet: bool,
    as_json: bool,
    **selection: str | None,
) -> None:
    """Write all work into one file for another PC, which reads it with `pinel merge`.

    DEST is a folder or a file name. An existing file is not replaced; the new one gets a number.
    """
    named = [name for name in selection.values() if name is not None]
    if len(named) > 1:
        raise click.UsageError("--class, --group and --program cannot be combined")
    with opened_store(chosen_database(ctx), may_be_new=False) as store:
        scope = _scope(store, **selection)
        computer = _computer(store)
        nameless = describe("file_without_names", {}, language_of_system()).message
        name = nameless if anonymous else "-".join([computer[1], *named])
        exchange = store.exchange
        write = exchange.export_parquet if parquet else exchange.export
        info = write(
            _file(dest, name, "" if parquet else SUFFIX),
            app_version=__version__,
            computer=computer,
            scope=scope,
            anonymous=shipped_texts() if anonymous else None,
        )
    click.echo(json.dumps(_as_object(info), ensure_ascii=False) if as_json else _as_text(info))
    _print_left_out(info)


def _scope(store: Store, *, classroom: str | None, group: str | None, program: str | None) -> Scope:
    if classroom is not None:
        return Scope(classroom_id=key_of(classroom, store.classrooms.all()))
    if group is not None:
        return Scope(group_id=key_of(group, store.groups.all()))
    if program is not None:
        groups = store.groups.all()
        programs = [one for group in groups for one in store.programs.of_group(group.id)]
        return Scope(program_id=key_of(program, programs))
    return Scope()


def _computer(store: Store) -> tuple[str, str]:
    """Returns key and name of this PC; placeholders if the database cannot store them."""
    try:
        return store.computers.this()
    except StoreError:
        return new_id(), platform.node() or "PC"


def _file(dest: Path, name: str, suffix: str) -> Path:
    if dest.is_dir():
        plain = re.sub(r"[^\w-]+", "-", name).strip("-")
        return dest / f"{plain or 'pinel'}-{datetime.now():%Y-%m-%d}{suffix}"
    return dest if dest.suffix else dest.with_suffix(suffix)


def _as_object(info: BundleInfo) -> dict[str, Any]:
    return {**asdict(info), "path": str(info.path)}


def _as_text(info: BundleInfo) -> str:
    language = language_of_system()
    return describe("exported", {"path": str(info.path), **info.counts}, language).message


def _print_left_out(info: BundleInfo) -> None:
    """Prints on standard error, apart from the result, which rows the file lacks."""
    if info.left_out:
        missing = describe("export_left_out", info.left_out_params, language_of_system())
        click.echo(missing.line, err=True)
