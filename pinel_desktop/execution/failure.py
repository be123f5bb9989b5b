"""What ends a run before its time."""

from pinel_desktop.errors import PinelError


class RunFailureError(PinelError):
    """The run cannot go on: its code is the run's reason."""
