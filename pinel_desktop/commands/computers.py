"""`pinel computers`: lists the PCs whose work is here by the fingerprint of their key, and approves one."""

import click

from pinel_desktop.commands.database import opened_store
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from storage import Store
from storage.exchange.signing import fingerprint


@click.command()
@click.option("--approve", metavar="FINGERPRINT", help="Let passes of this PC count at once.")
@click.option("--withdraw", metavar="FINGERPRINT", help="Take an approval back.")
@database_option
@click.pass_context
def command(ctx: click.Context, approve: str | None, withdraw: str | None) -> None:
    """List the PCs whose signed work was merged here, with their fingerprints; this PC first.

    The fingerprint of a PC is shown on that PC by `pinel computers`, and on its page for the teacher. Compare before
    approving (docs/bundles.md).
    """
    with opened_store(chosen_database(ctx), may_be_new=True) as store:
        if approve:
            store.computer_keys.approve(_key(store, approve))
        if withdraw:
            store.computer_keys.withdraw(_key(store, withdraw))
        for line in _lines(store):
            click.echo(line)


def _key(store: Store, wanted: str) -> str:
    """The key of that fingerprint. Raises PinelError `fingerprint_unknown`."""
    plain = wanted.replace("-", "").replace(" ", "").upper()
    for one in store.computer_keys.all():
        if fingerprint(one.public_key).replace("-", "") == plain:
            return one.public_key
    raise PinelError("fingerprint_unknown", fingerprint=wanted)


def _lines(store: Store) -> list[str]:
    own = store.exchange.own_fingerprint() or "-"
    lines = [_line(own, store.computers.this()[1], "computer_is_this")]
    for one in store.computer_keys.all():
        state = "computer_approved" if one.approved_at else "computer_not_approved"
        lines.append(_line(fingerprint(one.public_key), one.name, state))
    return lines


def _line(code: str, name: str, state: str) -> str:
    return f"{code:<14}  {name}  ({describe(state, {}, language_of_system()).message})"
