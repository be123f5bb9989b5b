"""Diagnostics of reading a Python text: faults with their places, and the place of each part of the document."""

import ast
from bisect import bisect_left
from functools import lru_cache
from itertools import accumulate
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.python_text.comments import Anchor
from pinel_desktop.program.python_text.scanning import MAX_FAULTS, SyntaxProblem, TextPosition
from pinel_desktop.program.python_text.writing import TextLine

Positioned = ast.stmt | ast.expr | ast.arg | ast.keyword


class Diagnostics:
    """Faults, places and anchors of one text. Columns count characters from 0 here, from 1 in faults.

    Faults on skipped lines are ignored, because the parser saw a replacement there.
    """

    def __init__(self, lines: list[str], skipped: set[int]) -> None:
        self._lines, self._skipped = lines, skipped
        self._faults: list[tuple[TextPosition, Fault]] = []
        self._offsets = lru_cache(maxsize=16)(self._count_offsets)
        self._is_too_deep = False
        self.anchors: list[Anchor] = []
        self.nodes: dict[str, Positioned] = {}
        self.lines: dict[int, TextLine] = {}

    def position(self, node: Positioned) -> TextPosition:
        """Returns the start of a node of Python's syntax tree, whose own columns count bytes."""
        line = self._lines[node.lineno - 1]
        if line.isascii():
            return TextPosition(node.lineno, node.col_offset)
        return TextPosition(node.lineno, bisect_left(self._offsets(node.lineno), node.col_offset))

    def _count_offsets(self, line: int) -> list[int]:
        sizes = (len(char.encode("utf-8", "replace")) for char in self._lines[line - 1])
        return list(accumulate(sizes, initial=0))

    @property
    def is_full(self) -> bool:
        """True if there are so many faults that reading further is useless."""
        return len(self._faults) >= MAX_FAULTS

    def fault(self, node: Positioned, code: str, **params: object) -> None:
        """Records a fault at a node."""
        place = self.position(node)
        if place.line not in self._skipped:
            self._add(place, Fault(code, params=params))

    def problem(self, problem: SyntaxProblem) -> None:
        """Records a syntax problem."""
        self._add(problem.position, Fault(problem.code, params=problem.params))

    def add_document_fault(self, fault: Fault) -> None:
        """Records a fault of the document at the place in the text of its pointer."""
        place = self.position_of(fault.pointer)
        if place.line not in self._skipped:
            self._add(place, fault)

    def position_of(self, pointer: str) -> TextPosition:
        """The place of a part of the document, or of the nearest enclosing part."""
        while pointer:
            if pointer in self.nodes:
                return self.position(self.nodes[pointer])
            pointer = pointer.rpartition("/")[0]
        return TextPosition(1, 0)

    def _add(self, place: TextPosition, fault: Fault) -> None:
        """Records a fault. A replaced line may be longer than the original, so the column is limited."""
        if self.is_full or (self._is_too_deep and fault.code == "nesting_too_deep"):
            return
        # reported once; all inner parts are too deep as well
        self._is_too_deep |= fault.code == "nesting_too_deep"
        column = min(place.column, len(self._lines[place.line - 1]))
        params = {**fault.params, "line": place.line, "column": column + 1}
        self._faults.append((place, Fault(fault.code, fault.pointer, fault.block, params)))

    def faults(self) -> tuple[Fault, ...]:
        """All faults in the order of the text, without repetitions."""
        ordered = sorted(self._faults, key=lambda entry: (entry[0].line, entry[0].column))
        unique: dict[Any, Fault] = {}
        for place, fault in ordered:
            unique.setdefault((place, fault.code), fault)
        return tuple(unique.values())

    def anchor(self, node: ast.stmt, last_line: int, target: dict[str, Any] | None) -> None:
        """Records the anchor of a command for comments."""
        place = self.position(node)
        self.anchors.append(Anchor(place.line, place.column, last_line, target))

    def line(self, node: ast.stmt, pointer: str) -> None:
        """Records the command of a line; of several, the first."""
        self.lines.setdefault(node.lineno, TextLine(pointer))
