"""The files that are written, whole or between two marks, from the models."""

from pathlib import Path

from pinel_desktop.program.reference import tables
from pinel_desktop.program.reference.schema import schema_text
from pinel_desktop.program.reference.sensor_rows import sensor_rows

_TABLES = {
    "docs/program-document.md": {
        "commands": tables.commands_of_the_document,
        "sensors": tables.sensors_of_the_document,
    },
    "docs/python-text.md": {
        "commands": tables.commands_in_python,
        "sensors": tables.sensors_in_python,
    },
}


def files(root: Path) -> dict[str, str]:
    """The text of each file, by its path from the repository's root; of pages, with what a person wrote in them."""
    pages = {name: (root / name).read_text("utf-8") for name in _TABLES}
    for name, made in _TABLES.items():
        for mark, rows in made.items():
            pages[name] = _with_rows(pages[name], mark, rows())
    return {
        "pinel_desktop/program/schema.json": schema_text(),
        "ui/src/blocks/table/sensor_rows.ts": sensor_rows(),
        **pages,
    }


def _with_rows(page: str, mark: str, rows: list[str]) -> str:
    """The page with these lines between the two marks, which are comments."""
    begin, end = f"<!-- {mark} -->\n", f"<!-- end of {mark} -->"
    before, _, rest = page.partition(begin)
    _, _, after = rest.partition(end)
    return f"{before}{begin}" + "".join(f"{row}\n" for row in rows) + f"{end}{after}"
