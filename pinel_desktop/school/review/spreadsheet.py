"""Tables as the spreadsheets of a language open them with a double click."""

import csv
import io
from collections.abc import Iterable, Sequence

from pinel_desktop.messages import decimal_sign

# spreadsheets read a file without this as if it were written in another century's letters
_BYTE_ORDER_MARK = "\ufeff"
# what a spreadsheet takes for a formula, which a pupil may have written into a name; some take wide signs too
_BEGINS_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\uff1d", "\uff0b", "\uff0d", "\uff20")

Cell = str | int | float | bool | None


def spreadsheet(header: Sequence[str], rows: Iterable[Sequence[Cell]], language: str) -> str:
    """CSV with semicolons where the language writes decimal commas, as in Portuguese, and commas elsewhere.

    Texts that a spreadsheet would take for a formula are written with an apostrophe before them, and stay texts.
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
