"""Fails on identifiers that use a private word where the field has a term.

Reads what Python files declare (by `ast`) and what the page declares (by TypeScript's parser, `names.mjs`). Exempt are
names that files of schools or HTTP record, which must not change, and names that another library demands.
"""

import ast
import json
import re
import subprocess
import sys
from collections.abc import Iterable, Iterator
from contextlib import closing
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from pinel_desktop.activities.model import Activity
from pinel_desktop.messages import LANGUAGES, catalogue
from pinel_desktop.web.description import description
from scripts.reference import schemas
from storage.sql import column_names
from storage.sqlite import sqlite3
from storage.tables.migrations import migrate

ROOT = Path(__file__).resolve().parents[1]
# docs/glossary.md has the terms to write instead
BANNED = frozenset(
    re.findall(
        r"\w+",
        """
        told tell tells telling heard hear hears stand stands standing stood doomed dead know knows knew seen see sees
        saw take takes taken taker kept keep keeps keeping keeper mend mended mending odd strange spoiled sums soundness
        glimpse ballot vote doubt patience patient silence silent deaf alive anew begun began gone way ways thing things
        wanted want wish wishes learn learnt learner remembered remember remains noted vouched vouches vouch slack peek
        most least longest largest greatest fastest shortest smallest slowest apart elsewhere mouth hole shelf palette
        later lit quietly wake awake owned look looks looked words word say says said
        """,
    )
)
BANNED_PHRASES = (
    ("stand", "in"), ("made", "up"), ("hand", "on"), ("go", "on"), ("goes", "on"), ("going", "on"),
    ("take", "over"), ("put", "right"), ("set", "aside"),
)  # fmt: skip
# of other libraries, or the name of a command, check or block of the program's language, in any spelling
# the last one is an option of gifenc
EXEMPT = frozenset({"peek", "say", "says", "KEEP_LAST", "look_at", "palette"})
TEXTS = re.compile(r"i18n/catalogue_types\.ts")  # the keys of the texts

Declaration = tuple[str, int, str]


def split(name: str) -> list[str]:
    """Splits an identifier: `takeBack_s` -> ["take", "back", "s"]."""
    parted = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", name)
    parted = re.sub(r"([A-Z]+)([A-Z][a-z])", r"\1_\2", parted)
    return [part for part in parted.lower().split("_") if part]


def banned_in(name: str) -> list[str]:
    """Returns the banned words and phrases of an identifier."""
    parts = split(name)
    found = [part for part in parts if part in BANNED]
    pairs = set(pairwise(parts))
    return found + [" ".join(phrase) for phrase in BANNED_PHRASES if phrase in pairs]


def declared_in(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Line and name of all that a Python file declares; a test's name is a sentence and is left out."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
                if not node.name.startswith("test_"):
                    yield node.lineno, node.name
            case ast.arg():
                yield node.lineno, node.arg
            case ast.Name(ctx=ast.Store()):
                yield node.lineno, node.id
            case ast.Attribute(ctx=ast.Store()):
                yield node.lineno, node.attr
            case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)):
                yield node.lineno, name
            case ast.alias(asname=str(name)):
                yield node.lineno, name


def python_declarations() -> Iterator[Declaration]:
    listed = subprocess.run(
        ("git", "ls-files", "--cached", "--others", "--exclude-standard", "*.py"),
        cwd=ROOT, check=True, capture_output=True, text=True,
    )  # fmt: skip
    for file in listed.stdout.splitlines():
        if (ROOT / file).exists():
            tree = ast.parse((ROOT / file).read_text("utf-8"))
            yield from ((file, line, name) for line, name in declared_in(tree))


def page_declarations() -> Iterator[Declaration]:
    script = 'PATH="$(sh scripts/node.sh):$PATH" && exec node scripts/names.mjs'
    printed = subprocess.run(
        ("sh", "-c", script), cwd=ROOT, check=True, capture_output=True, text=True
    )
    for file, line, name in json.loads(printed.stdout):
        if not TEXTS.match(file) and file != "api/types.ts":
            yield f"ui/src/{file}", line, name


@cache
def recorded_names() -> frozenset[str]:
    """Names of HTTP, of the database, and of the documents that files hold."""
    documents = (
        description(),
        schemas.of_programs(),
        schemas.of_worlds(),
        Activity.model_json_schema(),
    )
    found = {name for document in documents for name in _keys(document)}
    found |= set(_columns())
    for language in LANGUAGES:
        for message in catalogue(language).values():
            found |= set(re.findall(r"\{(\w+)\}", " ".join(message.values())))
    return frozenset(found)


def _columns() -> Iterator[str]:
    """Names of all tables and columns of a store."""
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as db:
        migrate(db)
        for (table,) in db.execute("SELECT name FROM sqlite_schema").fetchall():
            yield table
            yield from column_names(db, table)


def _keys(document: Any) -> Iterator[str]:
    """All keys and all short texts of a JSON document: properties, parameters, constants."""
    if isinstance(document, dict):
        for key, value in document.items():
            yield key
            yield from _keys(value)
    elif isinstance(document, list):
        for item in document:
            yield from _keys(item)
    elif isinstance(document, str) and document.isidentifier():
        yield document


def violations(declarations: Iterable[Declaration]) -> list[str]:
    """Each name once for each file, with its first line."""
    allowed = EXEMPT | recorded_names()
    first: dict[tuple[str, str], int] = {}
    for file, line, name in declarations:
        if banned_in(name) and name.lstrip("_") not in allowed:
            first.setdefault((file, name), line)
    return [
        f"{file}:{line}: {name} ({', '.join(banned_in(name))})"
        for (file, name), line in sorted(first.items())
    ]


if __name__ == "__main__":
    found = violations([*python_declarations(), *page_declarations()])
    print("\n".join(found))
    if found:
        sys.exit(f"{len(found)} names use a private word: docs/glossary.md has the terms")
