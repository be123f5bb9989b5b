"""Where the program begins: `pinel`, `python -m pinel_desktop`, and the package."""

import atexit
import gc
import sys


def main() -> None:
    """Runs the command that was typed; without one it opens the window, with nothing to read but what that needs."""
    if len(sys.argv) > 1:
        from pinel_desktop.cli import main as run_command  # noqa: PLC0415 - a person waits for the window

        # at the end what is left is not searched for cycles: that takes the processor 0.2 s
        atexit.register(gc.freeze)
        run_command()
    else:
        from pinel_desktop.commands.window import open_app  # noqa: PLC0415 - see above

        sys.exit(open_app(None))


if __name__ == "__main__":
    main()
