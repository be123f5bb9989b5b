"""Contact sheets: many screenshots side by side, to judge them together."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TypeVar

import cv2
import numpy as np
import numpy.typing as npt

T = TypeVar("T")
Picture = npt.NDArray[np.uint8]

_WIDTH, _LABEL, _GAP = 1800, 22, 6


def contact_sheets(folder: Path, variant: str, columns: int) -> Iterator[Path]:
    """Writes sheets of all pictures of a variant, `SIZE-THEME-LANGUAGE`; yields their paths."""
    pictures = sorted(folder.glob(f"*-{variant}.png"))
    for number, few in enumerate(_batches(pictures, columns * columns), start=1):
        path = folder / f"sheet-{variant}-{number}.png"
        cv2.imwrite(str(path), _sheet(few, variant, columns))
        yield path


def _sheet(pictures: Sequence[Path], variant: str, columns: int) -> Picture:
    cells = [
        _cell(one, one.stem.removesuffix(f"-{variant}"), _WIDTH // columns) for one in pictures
    ]
    return np.vstack([_row(row, columns) for row in _batches(cells, columns)])


def _row(cells: Sequence[Picture], columns: int) -> Picture:
    """Cells side by side, as high as the highest, on white."""
    width = cells[0].shape[1]
    row = np.full((max(len(one) for one in cells), width * columns, 3), 255, np.uint8)
    for place, one in enumerate(cells):
        row[: len(one), place * width : (place + 1) * width] = one
    return row


def _batches(all_: Sequence[T], size: int) -> list[Sequence[T]]:
    return [all_[place : place + size] for place in range(0, len(all_), size)]


def _cell(path: Path, title: str, width: int) -> Picture:
    image = cv2.imread(str(path))
    assert image is not None, path
    height = round(image.shape[0] * (width - _GAP) / image.shape[1])
    small = cv2.resize(image, (width - _GAP, height), interpolation=cv2.INTER_AREA)
    cell = np.full((height + _LABEL + _GAP, width, 3), 255, np.uint8)
    cell[_LABEL : _LABEL + height, : width - _GAP] = small
    cv2.putText(cell, title, (2, 15), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (0, 0, 160), 1, cv2.LINE_AA)
    return cell
