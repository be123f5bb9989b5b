"""The tests of the page look at nothing that they did not wait for: `expect` tries again, a bare read does not."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.packaging.loading import ROOT

FILES = sorted((ROOT / "tests" / "e2e").glob("test_*.py"))
# what a locator answers at once, as it is at this moment
READS = {
    "all_inner_texts",
    "all_text_contents",
    "count",
    "get_attribute",
    "inner_html",
    "inner_text",
    "input_value",
    "is_checked",
    "is_disabled",
    "is_editable",
    "is_enabled",
    "is_hidden",
    "is_visible",
    "number",
    "text_content",
}
# what also goes through whatever is there so far, or where it is so far
IMMEDIATE_READS = {"all", "all_inner_texts", "bounding_box", "screenshot"}
WAITS = {
    "cut",
    "eventually",
    "expect",
    "violations",
    "wait_for",
    "wait_for_phase",
    "wait_for_screen",
}


def calls(node: ast.AST, names: set[str]) -> Iterator[ast.Call]:
    """Calls of these names, but not those inside a function that somebody else calls again and again."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Lambda | ast.FunctionDef):
            continue  # what `eventually` calls until it is so
        if isinstance(child, ast.Call) and name_of(child) in names:
            yield child
        yield from calls(child, names)


def name_of(call: ast.Call) -> str:
    match call:
        case ast.Call(func=ast.Name(id="expect" | "cut" | "violations" as name)):
            return name
        case ast.Call(func=ast.Attribute(attr="count"), args=[_]):
            return ""  # of a list
        case ast.Call(func=ast.Attribute(attr=name)):
            return name
    return ""


def is_of_blocks(call: ast.Call) -> bool:
    """`Blocks.all` finds, and reads nothing."""
    return isinstance(call.func, ast.Attribute) and ast.unparse(call.func.value).endswith("blocks")


def bare_reads(source: str) -> list[str]:
    """Lines that compare what the page happens to show, and those that go through what it happens to show."""
    found: list[ast.Call] = []
    tree = ast.parse(source)
    for one in ast.walk(tree):
        if isinstance(one, ast.Assert):
            found += calls(one, READS)
    for function in tree.body:
        if isinstance(function, ast.FunctionDef):
            waited = min((one.lineno for one in calls(function, WAITS)), default=10**6)
            immediate = [one for one in calls(function, IMMEDIATE_READS) if not is_of_blocks(one)]
            found += [one for one in immediate if one.lineno < waited]
    return [f"{one.lineno}: {ast.unparse(one)}" for one in found]


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_look_at_the_page_waits_for_what_it_looks_at(file: Path) -> None:
    assert bare_reads(file.read_text("utf-8")) == []


@pytest.mark.parametrize(
    "line",
    [
        "assert studio['group-card'].count() == 2",
        "assert studio['pin'].is_visible()",
        "assert [one.get_attribute('data-name') for one in rows] == ['a']",
        "for one in rows.all(): one.check()",
        "box = one.bounding_box()",
        "before = studio['scene'].screenshot()",
    ],
)
def test_a_look_that_does_not_wait_is_found(line: str) -> None:
    assert bare_reads(f"def test_it(studio):\n    {line}\n")


@pytest.mark.parametrize(
    "lines",
    [
        "expect(studio['group-card']).to_have_count(2)",
        "studio.eventually(lambda: marks.count(), 2)",
        "expect(rows).to_have_count(2)\n    for one in rows.all(): one.check()",
        "studio.blocks.all().first.click()",
    ],
)
def test_a_look_that_waits_is_none(lines: str) -> None:
    assert bare_reads(f"def test_it(studio):\n    {lines}\n") == []
