"""The telemetry codec: packs samples as small as the precision that people use allows.

A chunk has about a second. Each column is quantised to a whole number of steps and stored as differences from row to
row. These are small, as the robot moves smoothly. The bytes of all columns are shuffled, as the high bytes are nearly
all zero, and packed by zlib. The result is a small part of the size of float32 columns.
"""

import json
import struct
import zlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

RATE_HZ = 30
STEPS: dict[str, float] = {
    "tick": 1.0,
    "x_m": 1e-4,
    "y_m": 1e-4,
    "yaw_rad": 1e-4,
    "v_mps": 1e-4,
    "omega_radps": 1e-4,
    "command_v_mps": 1e-4,
    "command_omega_radps": 1e-4,
    "goal_x_m": 1e-4,
    "goal_y_m": 1e-4,
    "goal_yaw_rad": 1e-4,
    "done": 1e-3,  # m, degrees or s
    "bumper": 1.0,
    "true_x_m": 1e-4,
    "true_y_m": 1e-4,
    "true_yaw_rad": 1e-4,
}
COLUMNS = tuple(STEPS)
Rows = NDArray[np.float64]
_STEP = np.array(list(STEPS.values()))
_MISSING = np.int32(-(2**31))  # null, which float columns read back as NaN
_LIMIT = float(2**31 - 1)


@dataclass(frozen=True, slots=True)
class Telemetry:
    """Samples of a run at 30 Hz: `rows` has shape (n, 16), columns as in `COLUMNS`, NaN for null."""

    rows: Rows

    def column(self, name: str) -> Rows:
        """Returns one column by its name, shape (n,)."""
        return self.rows[:, COLUMNS.index(name)]

    def to_wire(self) -> bytes:
        """Encodes the length of the header (uint32), the header (JSON) and float32 columns, all little-endian."""
        header = {"columns": COLUMNS, "rows": len(self.rows), "rate_hz": RATE_HZ}
        text = json.dumps(header, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        return struct.pack("<I", len(text)) + text + self.rows.T.astype("<f4").tobytes()


def rows_of(events: Iterable[Mapping[str, object]]) -> Rows:
    """Returns telemetry events as rows; NaN for fields that an event lacks."""
    rows = [[_number(event.get(name)) for name in COLUMNS] for event in events]
    return np.array(rows, dtype=np.float64).reshape(-1, len(COLUMNS))


def pack(rows: Rows) -> bytes:
    """Packs rows of shape (n, 16) into a blob."""
    steps = np.clip(np.nan_to_num(np.rint(rows / _STEP)), -_LIMIT, _LIMIT).astype(np.int32)
    steps[np.isnan(rows)] = _MISSING
    differences = np.empty_like(steps)
    differences[:1] = steps[:1]
    # int32 differences may wrap around; the sum in `unpack` wraps back
    differences[1:] = steps[1:] - steps[:-1]
    octets = np.ascontiguousarray(differences.T.astype("<i4")).view(np.uint8).reshape(-1, 4)
    return zlib.compress(octets.T.tobytes(), 9)


def unpack(blob: bytes, n_rows: int) -> Rows:
    """Unpacks a blob of `pack`, to half a step. Columns that later releases added are NaN in earlier blobs.

    Raises:
        ValueError: the blob is not telemetry, or does not have that many rows.
    """
    try:
        octets = np.frombuffer(zlib.decompress(blob), dtype=np.uint8).reshape(4, -1)
    except (zlib.error, TypeError) as error:
        raise ValueError(f"not telemetry: {error}") from error
    n_columns = octets.shape[1] // n_rows if n_rows else len(COLUMNS)
    if not 0 < n_columns <= len(COLUMNS):
        raise ValueError(f"{n_columns} columns")
    differences = np.ascontiguousarray(octets.T).view("<i4").reshape(n_columns, n_rows)
    steps = np.cumsum(differences, axis=1, dtype=np.int32).T
    rows: Rows = np.full((n_rows, len(COLUMNS)), np.nan)
    rows[:, :n_columns] = steps * _STEP[:n_columns]
    rows[:, :n_columns][steps == _MISSING] = np.nan
    return rows


def joined(chunks: Sequence[tuple[bytes, int]]) -> Telemetry:
    """Unpacks and joins all chunks of a run, each a blob and its number of rows. Raises ValueError as `unpack`."""
    parts = [unpack(blob, n_rows) for blob, n_rows in chunks]
    return Telemetry(np.concatenate(parts) if parts else np.empty((0, len(COLUMNS))))


def _number(value: object) -> float:
    return float(value) if isinstance(value, int | float) else float("nan")
