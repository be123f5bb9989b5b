"""The check of identifiers finds private words wherever Python and the page declare names."""

import ast

import pytest

from scripts.names import banned_in, declared_in, page_declarations, recorded_names, violations


@pytest.mark.parametrize(
    ("name", "banned"),
    [
        ("kept_rows", ["kept"]),
        ("takeBack", ["take"]),
        ("HTTPWords", ["words"]),
        ("LONGEST_S", ["longest"]),
        ("stand_in", ["stand", "stand in"]),
        ("keyword", []),
        ("standstill", []),
    ],
)
def test_an_identifier_is_split_into_its_words(name: str, banned: list[str]) -> None:
    assert banned_in(name) == banned


def test_all_that_python_declares_is_read_but_names_of_tests() -> None:
    code = """
class Told: pass
def seen(gone, *, kept=0):
    way = self.thing = 1
    for word in (): pass
    with a as doomed, b as (mended,): pass
    try: pass
    except E as silent: pass
    match x:
        case [taken, *rest]: pass
import a as odd
def test_what_is_kept_is_seen(): pass
"""
    found = [name for _, name in declared_in(ast.parse(code))]
    assert sorted(name for name in found if banned_in(name)) == sorted(
        [
            "Told",
            "seen",
            "gone",
            "kept",
            "way",
            "thing",
            "word",
            "doomed",
            "mended",
            "silent",
            "taken",
            "odd",
        ]
    )


def test_the_page_is_read_too() -> None:
    files = {file for file, _, _ in page_declarations()}
    assert "ui/src/shell/route.ts" in files
    assert len(files) > 500


def test_what_http_and_files_record_is_exempt() -> None:
    assert {"is_kept", "n_wanted"} <= recorded_names()
    declared = [("a.py", 1, "is_kept"), ("a.py", 2, "is_told"), ("a.py", 9, "is_told")]
    assert violations(declared) == ["a.py:2: is_told (told)"]
