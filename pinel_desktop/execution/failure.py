"""The error that ends a run."""

from pinel_desktop.errors import PinelError


class RunFailureError(PinelError):
    """The run cannot continue; the code is the reason of the outcome `failed`."""
