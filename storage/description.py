"""docs/database.md, made from the tables and views themselves; a test holds it current.

`python -m storage.description > docs/database.md` writes it.
"""

import sqlite3
from contextlib import closing

from storage.schema import migrate

_HEAD = """\
# The file with everybody's work

One SQLite file. It opens in [Datasette](https://datasette.io), in DB Browser for SQLite and with `sqlite-utils`; open
a copy, or read only, while PINEL runs. Start with the views, which have names and times for people; the tables beneath
them have keys. The view `about` says in the file itself what is what.

Keys are UUIDv7 text, which sort by the time they were made. Times are ISO 8601 text in UTC, of the clock of the PC
where something happened. Text that holds JSON says so here. This page is made from the file's own definition by
`python -m storage.description`.
"""
_JSON = {
    "versions": ("workspace", "document", "faults", "world"),
    "runs": (
        "document",
        "world_document",
        "parameters",
        "params",
        "summary",
        "path",
        "check_report",
    ),
    "events": ("data",),
    "settings": ("value",),
    "merges": ("added",),
    "exports": ("content",),
}


def text() -> str:
    """The page."""
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as db:
        migrate(db)
        about = _meanings(db)
        views = [_view(db, name) for name in _names(db, "view") if name != "about"]
        tables = [_table(db, name, about) for name in _names(db, "table") if name in about]
    return "\n".join([_HEAD, "## Views\n", *views, "\n## Tables\n", *tables]).rstrip() + "\n"


def _names(db: sqlite3.Connection, kind: str) -> list[str]:
    rows = db.execute("SELECT name FROM sqlite_master WHERE type = ? ORDER BY name", [kind])
    return [str(row[0]) for row in rows]


def _meanings(db: sqlite3.Connection) -> dict[str, str]:
    """What `about` says; one line may be about several."""
    rows = db.execute("SELECT name, meaning FROM about")
    return {name: str(meaning) for names, meaning in rows for name in names.split(", ")}


def _view(db: sqlite3.Connection, name: str) -> str:
    columns = ", ".join(f"`{row[1]}`" for row in db.execute(f"PRAGMA table_info({name})"))
    return f"- **{name}**: {columns}"


def _table(db: sqlite3.Connection, name: str, about: dict[str, str]) -> str:
    leads_to = {row[3]: row[2] for row in db.execute(f"PRAGMA foreign_key_list({name})")}
    lines = [f"### {name}\n", f"{about[name]}\n", "| column | type | |", "|---|---|---|"]
    for _, column, kind, needed, _, key in db.execute(f"PRAGMA table_info({name})"):
        notes = [
            "key" if key else "",
            f"of `{leads_to[column]}`" if column in leads_to else "",
            "JSON" if column in _JSON.get(name, ()) else "",
            "" if needed or key else "may be empty",
        ]
        lines.append(f"| `{column}` | {kind} | {', '.join(filter(None, notes))} |")
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    print(text(), end="")
