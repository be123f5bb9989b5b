"""The command `pinel`. Each subcommand is a module in `commands/`, imported when it is called."""

import importlib

import click

from pinel_desktop import __version__
from pinel_desktop.commands.options import chosen_file, database_option

_COMMANDS = {
    "run": "Run a program and print its result.",
    "serve": "Serve the page without a window and print its address.",
    "sweep": "Run programs with many seeds and write a table.",
    "python": "Print a program as Python text.",
    "check": "Check whether programs fulfil an activity.",
    "runs": "List, show and verify recorded runs.",
    "calibrate": "Learn the errors of a real robot from its runs.",
    "export": "Write all work, or a part of it, into one file.",
    "merge": "Bring in the work of other PCs.",
    "salvage": "Bring in what is still readable of a damaged file.",
    "overhead": "Set up a camera above the floor, which sees where a real robot is.",
    "gestures": "Recognise letters of Libras in pictures.",
    "pin": "Choose another PIN for the teacher.",
    "setup": "Set up this PC by a file.",
    "update": "Update this PINEL by the file of a newer release.",
    "doctor": "Say what this PC has and lacks.",
}
_SUBMODULES = {
    "calibrate": "robots.calibrate",
    "overhead": "pc.overhead",
    "pin": "pc.pin",
    "salvage": "recovery.salvage",
    "setup": "pc.setup",
    "sweep": "batch.sweep",
    "update": "pc.update",
}
_SUPERVISED = ("camera", "cloud", "engine", "judge", "kiosk", "window")
_HIDDEN = {name: f"owned.{name}" for name in _SUPERVISED} | {"app": "app"}


class _LazyGroup(click.Group):
    """Imports a command's module on demand, so that `pinel engine` starts fast."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in _COMMANDS and cmd_name not in _HIDDEN:
            return None
        module = importlib.import_module(
            f"pinel_desktop.commands.{(_HIDDEN | _SUBMODULES).get(cmd_name, cmd_name)}"
        )
        command: click.Command = module.command
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(_COMMANDS.items()))


@click.group(cls=_LazyGroup, invoke_without_command=True)
@click.version_option(__version__, prog_name="pinel")
@database_option
@click.option(
    "--self-check", is_flag=True, help="Try window, simulator and store once; print JSON."
)
@click.option(
    "--kiosk", is_flag=True, help="Fill the screen; only the teacher can close the window."
)
@click.option("--place", default="", hidden=True)  # where the page opens again in kiosk mode
@click.option("--file", hidden=True)  # the file of `pinel FILE.pinel`, when PINEL opens again
@click.pass_context
def main(ctx: click.Context, self_check: bool, kiosk: bool, place: str, file: str | None) -> None:
    """PINEL Desktop. Without a command, opens the window; with FILE.pinel, where the teacher merges that file.

    Data is in the user's data folder; the variable PINEL_HOME or the option --db chooses another place.
    """
    db = chosen_file(ctx)
    if ctx.invoked_subcommand is None:
        from pinel_desktop.commands import window  # noqa: PLC0415 - the window's libraries are slow to import

        if self_check:
            ctx.exit(window.self_check(db))
        ctx.exit(window.open_app(db, kiosk=kiosk, place=place, file=file))
