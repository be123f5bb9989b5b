"""`pinel kiosk`: the window in kiosk mode, started by the watchdog (desktop/kiosk/watchdog.py).

Writes `{"place": ...}` to standard output whenever the page has gone to another place. At the end of its input it
closes the window, and opens PINEL again.
"""

import contextlib
import json
import os
import sys
import threading

import click

from pinel_desktop.commands.options import chosen_file
from pinel_desktop.commands.window import WindowProcess, pinel_command
from pinel_desktop.desktop.ending import become, end_process
from pinel_desktop.desktop.kiosk.mode import KioskMode, KioskReason
from pinel_desktop.processes.standard_streams import reserve_output


@click.command(hidden=True)
@click.option("--reason", type=click.Choice(["setting", "command"]), required=True)
@click.option("--place", default="")
@click.option("--file")
@click.pass_context
def command(ctx: click.Context, reason: KioskReason, place: str, file: str | None) -> None:
    """Open the window in kiosk mode for the watchdog."""
    db = chosen_file(ctx)
    places = os.fdopen(reserve_output(), "w", encoding="utf-8")

    def report_place(changed: str) -> None:
        nonlocal place
        place = changed
        with contextlib.suppress(OSError):  # the watchdog has ended, and so has the input
            places.write(json.dumps({"place": place}) + "\n")
            places.flush()

    window = WindowProcess(db, KioskMode(reason, place, report_place), file)
    watchdog_ended = threading.Event()

    def close_with_watchdog() -> None:
        # without Python's buffer, which this thread would hold at the end of the process
        while os.read(sys.stdin.fileno(), 4096):
            pass
        watchdog_ended.set()
        window.close()

    threading.Thread(target=close_with_watchdog, name="watchdog-pipe", daemon=True).start()
    status = window.run()
    if watchdog_ended.is_set():
        become(pinel_command(db, kiosk=reason == "command", place=place))
    end_process(status)
    ctx.exit(status)
