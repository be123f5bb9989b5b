"""The generated files and generated parts of files: between two markers, or from a marker to the end."""

from pathlib import Path

from pinel_desktop.web.description import description_text
from scripts.reference import database, events_page, http_page, language_tables, schemas
from scripts.reference.block_films import films
from scripts.reference.check_kinds import check_fields, checks_of_activities
from scripts.reference.declared import declared
from scripts.reference.goals import goals
from scripts.reference.sensor_rows import sensor_rows

_TABLES = {
    "docs/activities.md": {"checks": checks_of_activities},
    "docs/http-api.md": {
        "errors of any route": http_page.errors_of_any_route,
        "errors of writing": http_page.errors_of_writing,
    },
    "docs/program-document.md": {
        "commands": language_tables.commands_of_the_document,
        "sensors": language_tables.sensors_of_the_document,
    },
    "docs/python-text.md": {
        "commands": language_tables.commands_in_python,
        "sensors": language_tables.sensors_in_python,
    },
}
_ENDS = {"docs/database.md": database.tables_and_views, "docs/parquet.md": database.parquet_columns}
_MARK = "<!-- what follows is made by `python -m scripts.reference` -->\n"


def files(root: Path) -> dict[str, str]:
    """Returns the text of each file by its path from the repository's root, with the hand-written parts of pages."""
    pages = {name: (root / name).read_text("utf-8") for name in (*_TABLES, *_ENDS)}
    for name, made in _TABLES.items():
        for mark, rows in made.items():
            pages[name] = _with_rows(pages[name], mark, rows())
    for name, end in _ENDS.items():
        pages[name] = f"{pages[name].partition(_MARK)[0]}{_MARK}\n{end()}"
    return {
        "pinel_desktop/program/schema.json": schemas.as_text(schemas.of_programs()),
        "sim/world.schema.json": schemas.as_text(schemas.of_worlds()),
        "ui/src/api/declared.ts": declared(),
        "ui/src/blocks/table/sensor_rows.ts": sensor_rows(),
        "ui/src/teacher/making/check_fields.ts": check_fields(),
        "ui/src/studio/help/films.json": films(),
        "docs/openapi.json": description_text(),
        "docs/events.md": events_page.text(),
        **goals(),
        **pages,
    }


def _with_rows(page: str, mark: str, rows: list[str]) -> str:
    """Replaces the lines of a page between two markers, which are HTML comments."""
    begin, end = f"<!-- {mark} -->\n", f"<!-- end of {mark} -->"
    before, _, rest = page.partition(begin)
    _, _, after = rest.partition(end)
    return f"{before}{begin}" + "".join(f"{row}\n" for row in rows) + f"{end}{after}"
