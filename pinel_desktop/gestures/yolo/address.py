"""Checks the file of a detector as far as possible without opening it, and without importing a network."""

from pathlib import Path

from pinel_desktop.errors import PinelError

ENDINGS = (".onnx", ".pt")
MAX_FILE_BYTES = 300_000_000


def check_file(path: Path) -> None:
    """Raises PinelError `detector_type_wrong`, `detector_missing`, `detector_too_large`."""
    if path.suffix.lower() not in ENDINGS:
        raise PinelError("detector_type_wrong", file=path.name, allowed=", ".join(ENDINGS))
    try:
        size = path.stat().st_size if path.is_file() else None
    except OSError:  # an invalid name, or a folder without permission to enter
        size = None
    if size is None:
        raise PinelError("detector_missing", file=str(path))
    if size > MAX_FILE_BYTES:
        megabytes = {"size": size // 1_000_000, "max": MAX_FILE_BYTES // 1_000_000}
        raise PinelError("detector_too_large", file=path.name, **megabytes)
