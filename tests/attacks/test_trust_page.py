"""docs/trust.md promises nothing that no test tries: each line of its tables of attacks names its tests in a comment.

The comment stands at the end of the line, `<!-- FILE::TEST ... -->`, with files as seen from tests/. The page in
Portuguese has the same lines, without names.
"""

import re
from pathlib import Path

TESTS = Path(__file__).parents[1]
DOCS = TESTS.parent / "docs"
_RULE = re.compile(r"\|(-+\|)+")
_NAMES = re.compile(r"<!-- (.+?) --> \|$")
_OF_PERSONS = ("| who |", "| quem |")


def tables(page: str) -> list[list[str]]:
    """The lines of each table of attacks."""
    found: list[list[str]] = []
    lines = (DOCS / page).read_text("utf-8").splitlines()
    for number, line in enumerate(lines):
        if _RULE.fullmatch(line) and not lines[number - 1].startswith(_OF_PERSONS):
            found.append([])
            for row in lines[number + 1 :]:
                if not row.startswith("|"):
                    break
                found[-1].append(row)
    return found


def names_in(line: str) -> list[str]:
    named = _NAMES.search(line)
    return named[1].split() if named else []


def is_test(name: str) -> bool:
    file, _, function = name.partition("::")
    path = TESTS / file
    return path.is_file() and re.search(rf"\bdef {function}\(", path.read_text("utf-8")) is not None


def test_each_line_of_the_page_names_tests_that_are_there() -> None:
    lines = [line for table in tables("trust.md") for line in table]
    assert len(lines) >= 20
    assert [line for line in lines if not names_in(line)] == []
    assert [name for line in lines for name in names_in(line) if not is_test(name)] == []


def test_the_page_in_portuguese_has_the_same_lines() -> None:
    english, portuguese = (list(map(len, tables(f"trust{ending}.md"))) for ending in ("", ".pt-BR"))
    assert portuguese == english
