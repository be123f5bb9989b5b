"""`pinel pin`: sets or removes the teacher's PIN, for a teacher who has forgotten it."""

from collections.abc import Sequence

import click

from pinel_desktop.commands.database import opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.printing import Failure
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from pinel_desktop.school.teacher import TeacherSessions, check_format, pin_hash


@click.command()
@click.option("--forget", is_flag=True, help="Remove the PIN; the page then asks for a new one.")
@click.option(
    "--hash",
    "as_hash",
    is_flag=True,
    help="Change nothing; print the line for a set-up file, which does not tell the PIN.",
)
@database_option
@click.pass_context
def command(ctx: click.Context, forget: bool, as_hash: bool) -> None:
    """Set a new PIN for the teacher, without the old one.

    Works while PINEL is open. Anybody who may write the database file can set the PIN (docs/teacher.md).
    """
    if as_hash:
        try:
            click.echo(f'pin_hash = "{pin_hash(_prompt_twice())}"')
        except PinelError as error:
            raise Failure(error) from error
        return
    with opened_store(chosen_database(ctx), may_be_new=True) as store:
        sessions = TeacherSessions(store.settings)
        if forget:
            sessions.remove_pin()
        else:
            sessions.set_pin(_prompt_twice())
    click.echo("\n".join(_message_lines("pin_taken_away" if forget else "pin_chosen")))


def _prompt_twice() -> str:
    """Prompts for a PIN twice. Raises PinelError `pin_format` or `pin_different`."""
    first = click.prompt(_message_lines("pin_prompt")[0], hide_input=True)
    check_format(first)
    again = click.prompt(_message_lines("pin_prompt_again")[0], hide_input=True)
    if first != again:
        raise PinelError("pin_different")
    return str(first)


def _message_lines(code: str) -> Sequence[str]:
    text = describe(code, {}, language_of_system())
    return [line for line in (text.message, text.remedy) if line]
