"""What a reader notes while it reads: faults with their places, and where each part of the document was."""

import ast
from bisect import bisect_left
from functools import lru_cache
from itertools import accumulate
from typing import Any

from pinel_desktop.program.faults import Fault
from pinel_desktop.program.python_text.comments import Anchor
from pinel_desktop.program.python_text.scanning import MAX_FAULTS, Place, Trouble
from pinel_desktop.program.python_text.writing import Line

Positioned = ast.stmt | ast.expr | ast.arg | ast.keyword


class Notes:
    """Faults, places and anchors of one text. Columns count characters from 0 here, from 1 in faults.

    On lines that were put aside stands something else than the text: nothing more is wrong there.
    """

    def __init__(self, lines: list[str], put_aside: set[int]) -> None:
        self._lines, self._put_aside = lines, put_aside
        self._faults: list[tuple[Place, Fault]] = []
        self._offsets = lru_cache(maxsize=16)(self._count_offsets)
        self._is_too_deep = False
        self.anchors: list[Anchor] = []
        self.places: dict[str, Positioned] = {}
        self.lines: dict[int, Line] = {}

    def place(self, node: Positioned) -> Place:
        """Where a node of Python's tree begins; its own columns count bytes."""
        line = self._lines[node.lineno - 1]
        if line.isascii():
            return Place(node.lineno, node.col_offset)
        return Place(node.lineno, bisect_left(self._offsets(node.lineno), node.col_offset))

    def _count_offsets(self, line: int) -> list[int]:
        sizes = (len(char.encode("utf-8", "replace")) for char in self._lines[line - 1])
        return list(accumulate(sizes, initial=0))

    @property
    def is_full(self) -> bool:
        """Whether there are so many faults that reading on makes no sense."""
        return len(self._faults) >= MAX_FAULTS

    def fault(self, node: Positioned, code: str, **params: object) -> None:
        """Notes what is wrong at a node."""
        place = self.place(node)
        if place.line not in self._put_aside:
            self._add(place, Fault(code, params=params))

    def trouble(self, trouble: Trouble) -> None:
        """Notes what kept a line from being parsed."""
        self._add(trouble.place, Fault(trouble.code, params=trouble.params))

    def placed(self, fault: Fault) -> None:
        """Notes a fault of the document at the place in the text that its pointer speaks of."""
        place = self.place_of(fault.pointer)
        if place.line not in self._put_aside:
            self._add(place, fault)

    def place_of(self, pointer: str) -> Place:
        """The place of a part of the document, or of the nearest part around it."""
        while pointer:
            if pointer in self.places:
                return self.place(self.places[pointer])
            pointer = pointer.rpartition("/")[0]
        return Place(1, 0)

    def _add(self, place: Place, fault: Fault) -> None:
        """Notes a fault. What was parsed may be longer than the line itself, where something was put in its place."""
        if self.is_full or (self._is_too_deep and fault.code == "nesting_too_deep"):
            return
        self._is_too_deep |= (
            fault.code == "nesting_too_deep"
        )  # said once: all that is inside is, too
        column = min(place.column, len(self._lines[place.line - 1]))
        params = {**fault.params, "line": place.line, "column": column + 1}
        self._faults.append((place, Fault(fault.code, fault.pointer, fault.block, params)))

    def faults(self) -> tuple[Fault, ...]:
        """All faults in the order of the text, each once."""
        ordered = sorted(self._faults, key=lambda noted: (noted[0].line, noted[0].column))
        seen: dict[Any, Fault] = {}
        for place, fault in ordered:
            seen.setdefault((place, fault.code), fault)
        return tuple(seen.values())

    def anchor(self, node: ast.stmt, last_line: int, target: dict[str, Any] | None) -> None:
        """Notes where comments of a command may stand."""
        place = self.place(node)
        self.anchors.append(Anchor(place.line, place.column, last_line, target))

    def line(self, node: ast.stmt, pointer: str) -> None:
        """Notes which command is on a line, the first of several."""
        self.lines.setdefault(node.lineno, Line(pointer))
