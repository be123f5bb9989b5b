"""`pinel setup`: sets up this PC by a file, the same on all PCs of a school."""

from pathlib import Path

import click

from pinel_desktop.commands.database import opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.pc import first_start
from pinel_desktop.commands.pc.for_all import install_for_all
from pinel_desktop.commands.printing import print_problem
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from pinel_desktop.school.pc_setup import PcSetupError, apply, read_pc_setup
from pinel_desktop.settings import Settings


@click.command()
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--check", is_flag=True, help="Only check the file; change nothing.")
@click.option("--system", is_flag=True, help="For every account of this PC, as administrator.")
@database_option
@click.pass_context
def command(ctx: click.Context, file: Path, check: bool, system: bool) -> None:
    """Set up this PC by FILE, a pinel.toml (docs/install.md).

    Sets what the file names, and leaves the rest as it is; the same file may be used again. If PINEL is open, the page
    shows the new values after a restart. With --system, the first start of PINEL in each account uses the file.
    Exit status: 0, or 1 if the file has a fault; then nothing was changed.
    """
    try:
        setup = read_pc_setup(file)
    except PcSetupError as error:
        for fault in error.faults:
            print_problem(fault)
        ctx.exit(1)
    code = "pc_setup_valid"
    if system and not check:
        try:
            install_for_all(file, setup)
        except OSError as error:
            problem = PinelError(
                "pc_setup_not_written", path=str(error.filename or first_start.SETUP_FILE.parent)
            )
            print_problem(problem)
            ctx.exit(1)
        code = "pc_setup_installed"
    elif not check:
        database = chosen_database(ctx)
        with opened_store(database, may_be_new=True) as store:
            apply(setup, store, Settings.beside(database))
        code = "pc_setup_applied"
    click.echo(describe(code, {"path": str(file)}, language_of_system()).line)
