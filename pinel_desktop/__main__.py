"""Entry point of `pinel`, of `python -m pinel_desktop`, and of the packaged program."""

import atexit
import gc
import sys

# of a bundle: a double click on one calls `pinel FILE.pinel`
_SUFFIX = ".pinel"


def main() -> None:
    """Runs the typed command. Without one, or with a bundle, opens the window, and imports only the modules for it."""
    if sys.platform == "win32":
        from pinel_desktop.processes.standard_streams import use_utf8  # noqa: PLC0415

        use_utf8()
    file = sys.argv[1] if len(sys.argv) == 2 and sys.argv[1].lower().endswith(_SUFFIX) else None
    if len(sys.argv) > 1 and file is None:
        from pinel_desktop.cli import main as run_command  # noqa: PLC0415 - would delay the window

        # without this, the last garbage collection at the exit costs 0.2 s of processor time
        atexit.register(gc.freeze)
        run_command()
    else:
        from pinel_desktop.commands.window import open_app  # noqa: PLC0415 - see above

        sys.exit(open_app(None, kiosk=False, file=file))


if __name__ == "__main__":
    main()
