"""Prints metrics of the code's structure in the working tree.

With --check: fails if a folder has more than FOLDER_LIMIT sources, or if the page has import circles or upward imports.
import-linter checks the imports of Python.
"""

import ast
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import Any

import grimp  # comes with import-linter

ROOT = Path(__file__).resolve().parents[1]
FOLDER_LIMIT = 20
PACKAGES = ("pinel_desktop", "sim", "storage")
CODE = re.compile(rf"(({'|'.join(PACKAGES)})/.*\.py|ui/src/.*\.(tsx?|css))$")
GENERATED = tuple(
    f"ui/src/{name}.ts"
    for name in (
        "api/declared",
        "api/types",
        "blocks/table/sensor_rows",
        "teacher/making/check_fields",
    )
)
PAGE_TEST = re.compile(r"ui/src/.*(\.test\.|/testing/)")  # testing/: imported only by tests
SOURCE = re.compile(r"(?!tests/)(?!.*\.test\.).*\.(py|mjs|tsx?)$")
RAW_CONTROL = re.compile(r"<(?:button|select)\b")
# folders of ui/src by layer, lowest first: none imports a later one; "screens" are all others
LAYERS = (
    "api", "i18n", "kit", "blocks", "editor", "shell", "run", "scene plots camera", "screens", "frame",
)  # fmt: skip

Edges = Iterable[tuple[str, str]]


def run(*command: str) -> str:
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout


def tree(pattern: re.Pattern[str]) -> list[str]:
    """Returns the files of the working tree that match and that git does not ignore."""
    listed = run("git", "ls-files", "--cached", "--others", "--exclude-standard").splitlines()
    return [name for name in listed if pattern.match(name) and (ROOT / name).exists()]


def text(name: str) -> str:
    return (ROOT / name).read_text("utf-8")


def n_lines(names: Iterable[str]) -> int:
    return sum(text(name).count("\n") for name in names)


def product() -> list[str]:
    """Returns the hand-written files of the product."""
    files = [name for name in tree(CODE) if name not in GENERATED]
    return [name for name in files if not PAGE_TEST.match(name)]


def full_folders() -> dict[str, int]:
    """Number of sources, without tests, of each folder that exceeds FOLDER_LIMIT."""
    sizes = Counter(str(Path(name).parent) for name in tree(SOURCE))
    return {folder: size for folder, size in sorted(sizes.items()) if size > FOLDER_LIMIT}


def function_lengths() -> list[int]:
    """Length in lines of each Python function of the product."""
    return [
        (node.end_lineno or 0) - node.lineno + 1
        for name in product()
        if name.endswith(".py")
        for node in ast.walk(ast.parse(text(name)))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]


def python_imports() -> Edges:
    """Returns imports as pairs of paths, including imports under TYPE_CHECKING and in functions."""
    graph = grimp.build_graph(*PACKAGES)
    for module in graph.modules:
        for imported in graph.find_modules_directly_imported_by(module):
            yield module.replace(".", "/"), imported.replace(".", "/")


def siblings(edges: Edges) -> Edges:
    """Replaces each import by an import between the sibling folders or files where the two paths diverge."""
    for importer, imported in edges:
        a, b = importer.split("/"), imported.split("/")
        shared = next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), None)
        if shared is not None:
            yield "/".join(a[: shared + 1]), "/".join(b[: shared + 1])


def import_cycles(edges: Edges) -> list[str]:
    """Returns the import circles; removes one import of each before the search for the next."""
    graph: dict[str, dict[str, None]] = {}
    for importer, imported in sorted(edges):
        graph.setdefault(importer, {})[imported] = None
    found = []
    while True:
        try:
            TopologicalSorter(graph).prepare()
        except CycleError as error:
            circle = error.args[1]
            del graph[circle[1]][circle[0]]
            found.append(" <- ".join(circle))
        else:
            return found


def layer_violations(edges: Edges) -> list[str]:
    """Returns imports of a higher layer of the page by a lower one."""
    named = {folder: place for place, names in enumerate(LAYERS) for folder in names.split()}

    def level(folder: str) -> int:
        """Files directly in ui/src (`main.tsx`, the lists of style sheets) are above all folders."""
        return len(LAYERS) if "." in folder else named.get(folder, named["screens"])

    pairs = [
        (importer, imported, importer.split("/")[0], imported.split("/")[0])
        for importer, imported in edges
    ]
    return [
        f"{importer} -> {imported}"
        for importer, imported, one, other in pairs
        if level(one) < level(other)
    ]


def spread(lengths: Iterable[int]) -> str:
    ordered = sorted(lengths)
    median, p90 = (ordered[int((len(ordered) - 1) * part)] for part in (0.5, 0.9))
    return f"median {median}, p90 {p90}, longest {ordered[-1]}, {len(ordered)} in all"


def show(title: str, value: object, details: Iterable[object] = ()) -> None:
    print(f"{title:<52} {value}")
    for detail in details:
        print(f"    {detail}")


def show_circles(language: str, edges: list[tuple[str, str]]) -> int:
    n_found = 0
    for kind, found in (
        ("files", import_cycles(edges)),
        ("folders", import_cycles(siblings(edges))),
    ):
        show(f"import circles of {kind}, {language}", len(found), found)
        n_found += len(found)
    return n_found


def page_metrics() -> dict[str, Any]:
    found: dict[str, Any] = json.loads(
        run("sh", "-c", 'PATH="$(sh scripts/node.sh):$PATH" node scripts/figures.mjs')
    )
    return found


def show_page(page: dict[str, Any]) -> None:
    components = page["components"]
    long = [f"{lines} {name}" for name, lines in components if lines > 60]
    show("lines of a component", spread(lines for _, lines in components))
    show("components of more than 60 lines", len(long), long)
    screens = [n for n in tree(re.compile(r"ui/src/(?!kit/).*\.tsx$")) if not PAGE_TEST.match(n)]
    show(
        "raw buttons and selects outside kit",
        sum(len(RAW_CONTROL.findall(text(n))) for n in screens),
    )


def main() -> int:
    is_check = "--check" in sys.argv[1:]
    full = full_folders()
    page = page_metrics()
    if not is_check:
        show("hand-written product lines, without tests and words", n_lines(product()))
        show("lines of the page's tests", n_lines(tree(PAGE_TEST)))
        show("lines of a Python function", spread(function_lengths()))
        show_circles("Python", list(python_imports()))
        show_page(page)
        show("lines of ARCHITECTURE.md", n_lines(["ARCHITECTURE.md"]))
    imports = [(one, other) for one, other in page["imports"]]
    n_circles, against = show_circles("TypeScript", imports), layer_violations(imports)
    show("imports of the page that point upwards", len(against), against)
    show(f"folders with more than {FOLDER_LIMIT} sources", len(full), full.items())
    return int(is_check and (bool(full) or n_circles > 0 or bool(against)))


if __name__ == "__main__":
    sys.exit(main())
