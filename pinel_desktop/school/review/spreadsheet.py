"""CSV text that spreadsheet programs open correctly by a double click."""

import csv
import io
from collections.abc import Iterable, Sequence

from pinel_desktop.messages import decimal_sign

# without a byte order mark, spreadsheets assume a legacy character set
_BYTE_ORDER_MARK = "\ufeff"
# first characters of formulas; names may start with them. Some spreadsheets accept full-width signs
# too.
_BEGINS_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\uff1d", "\uff0b", "\uff0d", "\uff20")

Cell = str | int | float | bool | None


def spreadsheet(header: Sequence[str], rows: Iterable[Sequence[Cell]], language: str) -> str:
    """Returns CSV text, separated by semicolons if the language has decimal commas, else by commas.

    If a spreadsheet would read a text as a formula, an apostrophe is put in front, so that it stays text.
    """
    point = decimal_sign(language)
    text = io.StringIO()
    writer = csv.writer(text, delimiter=";" if point == "," else ",", lineterminator="\r\n")
    writer.writerow([_text(title) for title in header])
    writer.writerows([_cell(cell, point) for cell in row] for row in rows)
    return _BYTE_ORDER_MARK + text.getvalue()


def _cell(cell: Cell, point: str) -> str:
    match cell:
        case None:
            return ""
        case bool():
            return str(int(cell))
        case float():
            return f"{cell:.3f}".rstrip("0").rstrip(".").replace(".", point)
        case int():
            return str(cell)
    return _text(cell)


def _text(text: str) -> str:
    clean = text.replace("\0", "")
    return f"'{clean}" if clean.startswith(_BEGINS_FORMULA) else clean
