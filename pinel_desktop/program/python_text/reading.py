"""Reads a Python text in the subset of docs/python-text.md as a document. The text is never executed."""

import ast
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.model import Program
from pinel_desktop.program.python_text.comments import attach
from pinel_desktop.program.python_text.diagnostics import Diagnostics
from pinel_desktop.program.python_text.names import program_name
from pinel_desktop.program.python_text.parsing import Parsed, parse
from pinel_desktop.program.python_text.read_expressions import ExpressionReader
from pinel_desktop.program.python_text.read_statements import Statements, docstring_of
from pinel_desktop.program.python_text.writing import TextLine
from pinel_desktop.program.reading import ParseResult, read_document

# faults that may be consequences of lines that cannot be read
_FOLLOWS = frozenset(
    {
        "break_outside_loop",
        "continue_outside_loop",
        "function_without_value",
        "missing_argument",
        "python_elif",
        "python_global_missing",
        "python_loop_else",
        "python_unknown_function",
        "return_outside_function",
        "unknown_argument",
        "unknown_function",
    }
)


@dataclass(frozen=True, slots=True)
class PythonParseResult:
    """Result of reading a Python text.

    Attributes:
        result: result of `read_document` for the resulting document.
        faults: all faults, in the order of the text, with `line` and `column` (from 1) in `params`.
        lines: the command of each line, counted from 1.
    """

    result: ParseResult
    lines: Mapping[int, TextLine] = field(default_factory=dict)

    @property
    def faults(self) -> tuple[Fault, ...]:
        return self.result.faults

    @property
    def program(self) -> Program | None:
        return self.result.program

    @property
    def document(self) -> dict[str, Any] | None:
        """The document in its normal form; None if there are faults."""
        return self.result.document


def read_python(text: str) -> PythonParseResult:
    """Reads a Python text. Never raises because of its content."""
    size = len(text.encode("utf-8", "replace"))
    if size > MAX_BYTES:
        params: dict[str, object] = {"value": size, "max": MAX_BYTES, "line": 1, "column": 1}
        return PythonParseResult(ParseResult(None, (Fault("document_too_large", params=params),)))
    lines = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    parsed = parse(lines)
    diagnostics = Diagnostics(lines.split("\n"), parsed.skipped)
    for problem in parsed.problems:
        diagnostics.problem(problem)
    if parsed.tree is None:
        return PythonParseResult(ParseResult(None, diagnostics.faults()))
    document = _document(parsed, parsed.tree, diagnostics)
    return PythonParseResult(_checked(document, diagnostics, parsed), diagnostics.lines)


def _document(parsed: Parsed, tree: ast.Module, diagnostics: Diagnostics) -> dict[str, Any]:
    name = docstring_of(tree.body)
    body = tree.body if name is None else tree.body[1:]
    defined = [node for node in body if isinstance(node, ast.FunctionDef)]
    others = [node for node in body if not isinstance(node, ast.FunctionDef)]
    signatures = {
        program_name(node.name): [program_name(arg.arg) for arg in node.args.args]
        for node in defined
    }
    statements = Statements(
        diagnostics, ExpressionReader(diagnostics, signatures), set(parsed.scan.elifs)
    )
    functions = [statements.function(node, f"/functions/{i}") for i, node in enumerate(defined)]
    commands = statements.program(others)
    attach(parsed.scan.comments, diagnostics.anchors)
    return {"pinel_ir": 1, "name": name or "", "functions": functions, "commands": commands}


def _checked(document: dict[str, Any], diagnostics: Diagnostics, parsed: Parsed) -> ParseResult:
    """Reads the document, and places its faults in the text."""
    reading = read_document(document)
    for fault in reading.faults:
        diagnostics.add_document_fault(fault)
    faults = diagnostics.faults()
    if parsed.problems:
        faults = tuple(fault for fault in faults if fault.code not in _FOLLOWS)
    return ParseResult(None, faults) if faults else reading
