"""The printed sheets: a page of five A4 sheets, each with a marker at its true size."""

from html import escape

from pinel_desktop.camera.overhead.markers import FLOOR_MARKERS, MARKER_BITS, MARKER_M, ROBOT_MARKER
from pinel_desktop.messages import describe

_SIDE_MM = round(1000 * MARKER_M)
_STYLE = """
@page { size: A4; margin: 0; }
body { margin: 0; font-family: sans-serif; text-align: center; }
section { width: 210mm; height: 296mm; page-break-after: always; overflow: hidden; }
h1 { margin: 14mm 20mm 4mm; font-size: 22pt; }
p { margin: 4mm 20mm; font-size: 13pt; }
svg { display: block; margin: 10mm auto; }
"""


def sheets_page(language: str) -> str:
    """Returns the page as HTML, which loads nothing."""
    sheets = "".join(_sheet(number, language) for number in (*FLOOR_MARKERS, ROBOT_MARKER))
    title = escape(describe("overhead_sheets", {}, language).message)
    return (
        f'<!DOCTYPE html><html lang="{language}"><head><meta charset="utf-8"><title>{title}</title>'
        f"<style>{_STYLE}</style></head><body>{sheets}</body></html>"
    )


def _sheet(number: int, language: str) -> str:
    code = "overhead_sheet_robot" if number == ROBOT_MARKER else "overhead_sheet_floor"
    text = describe(code, {"n": number + 1, "side": _SIDE_MM // 10}, language)
    arrow = '<path d="M80 -16 70 -2h20z"/>' if number == ROBOT_MARKER else ""
    return (
        f"<section><h1>{escape(text.message)}</h1>"
        f'<svg width="{_SIDE_MM}mm" height="{_SIDE_MM + 20}mm" viewBox="0 -20 160 180">{arrow}{_marker(number)}</svg>'
        f"<p>{escape(text.remedy)}</p></section>"
    )


def _marker(number: int) -> str:
    """Returns the marker as SVG, 160 units wide: a black square with white fields."""
    step = 160 / 6
    fields = "".join(
        f"M{(column + 1) * step:.3f} {(row + 1) * step:.3f}h{step:.3f}v{step:.3f}h-{step:.3f}z"
        for row, bits in enumerate(MARKER_BITS[number])
        for column, bit in enumerate(bits)
        if bit == "1"
    )
    return f'<path d="M0 0h160v160H0z"/><path fill="#fff" d="{fields}"/>'
