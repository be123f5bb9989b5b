"""Parser of condition strings, such as `result == "B"`, which the original PINEL wrote.

    condition  = and_part { ("or" | "||") and_part }
    and_part   = not_part { ("and" | "&&") not_part }
    not_part   = ("not" | "!") not_part | comparison
    comparison = operand [ ("==" | "!=" | "<" | ">" | "<=" | ">=") operand ]
    operand    = "result" | "resultado" | quoted text | number | "(" condition ")"

The original passed these strings to eval(). Here anything outside the grammar is a fault.
"""

import re
from typing import NamedTuple

from pinel_desktop.program.limits import MAX_NESTING, MAX_TEXT

Tree = dict[str, object] | str | float

_TOKEN = re.compile(
    r"""[ \t]*(?:
        (?P<text>"[^"]*"|'[^']*')
      | (?P<number>[+-]?(?:[0-9]{1,300}(?:\.[0-9]{0,300})?|\.[0-9]{1,300}))(?![\w.])
      | (?P<word>[A-Za-z_]+)(?![\w.])
      | (?P<sign>==|!=|<=|>=|&&|\|\||[<>!()])
    )""",
    re.VERBOSE,
)
_LOGIC_OPERATORS = {"and": "and", "or": "or", "not": "not", "&&": "and", "||": "or", "!": "not"}
_COMPARISONS = ("==", "!=", "<=", ">=", "<", ">")


class ConditionError(ValueError):
    """The text is not a condition: the unexpected token `found` at `position`, counted from 1."""

    def __init__(self, position: int, found: str) -> None:
        super().__init__(f"{found!r} at {position}")
        self.position, self.found = position, found


class _Token(NamedTuple):
    kind: str
    value: str
    position: int


def parse_condition(text: str) -> Tree:
    """Parses a condition string to an expression tree, as document data. Raises ConditionError."""
    if len(text) > MAX_TEXT:
        raise ConditionError(MAX_TEXT, text[MAX_TEXT : MAX_TEXT + 20])
    return _Parser(_tokens(text)).parse()


def _tokens(text: str) -> list[_Token]:
    tokens: list[_Token] = []
    position, end = 0, len(text.rstrip(" \t"))
    while position < end:
        match = _TOKEN.match(text, position)
        if match is None or match.lastgroup is None:
            start = position + len(text[position:]) - len(text[position:].lstrip(" \t"))
            raise ConditionError(start + 1, text[start : start + 20])
        value = match[match.lastgroup]
        kind = "logic" if value in _LOGIC_OPERATORS else match.lastgroup
        tokens.append(_Token(kind, value, match.start(match.lastgroup) + 1))
        position = match.end()
    tokens.append(_Token("end", "", end + 1))
    return tokens


class _Parser:
    def __init__(self, tokens: list[_Token]) -> None:
        self._tokens = tokens
        self._index = 0
        self._depth = 0

    def parse(self) -> Tree:
        tree = self._joined("or")
        if self._next.kind != "end":
            raise self._unexpected()
        return tree

    @property
    def _next(self) -> _Token:
        return self._tokens[self._index]

    def _advance(self) -> _Token:
        token = self._next
        self._index += 1
        return token

    def _unexpected(self) -> ConditionError:
        return ConditionError(self._next.position, self._next.value)

    def _at_logic(self, operator: str) -> bool:
        return self._next.kind == "logic" and _LOGIC_OPERATORS[self._next.value] == operator

    def _joined(self, operator: str) -> Tree:
        parts = [self._joined("and") if operator == "or" else self._negated()]
        while self._at_logic(operator):
            self._advance()
            parts.append(self._joined("and") if operator == "or" else self._negated())
        return parts[0] if len(parts) == 1 else {"op": operator, "args": parts}

    def _negated(self) -> Tree:
        if not self._at_logic("not"):
            return self._comparison()
        self._enter()
        self._advance()
        tree: Tree = {"op": "not", "args": [self._negated()]}
        self._depth -= 1
        return tree

    def _comparison(self) -> Tree:
        left = self._operand()
        if self._next.kind != "sign" or self._next.value not in _COMPARISONS:
            return left
        sign = self._advance().value
        return {"op": sign, "args": [left, self._operand()]}

    def _operand(self) -> Tree:
        token = self._next
        if token.kind == "text":
            return self._advance().value[1:-1]
        if token.kind == "number":
            return float(self._advance().value)
        if token.kind == "word" and token.value in ("result", "resultado"):
            self._advance()
            return {"gesture": "result"}
        if token.value == "(" and token.kind == "sign":
            return self._group()
        raise self._unexpected()

    def _group(self) -> Tree:
        self._enter()
        self._advance()
        tree = self._joined("or")
        if self._next.value != ")" or self._next.kind != "sign":
            raise self._unexpected()
        self._advance()
        self._depth -= 1
        return tree

    def _enter(self) -> None:
        self._depth += 1
        if self._depth > MAX_NESTING:
            raise self._unexpected()
