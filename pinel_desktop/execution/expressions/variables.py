"""The variables of a run: globals, and the parameters of the running function."""

from typing import Any

from pinel_desktop.execution.expressions.values import Value, plain, size
from pinel_desktop.execution.failure import RunFailureError
from pinel_desktop.execution.limits import MAX_MEMORY
from pinel_desktop.program.limits import MAX_LIST, MAX_VARIABLES

Names = dict[str, Value]


class Variables:
    """Names and their values. Lists have value semantics: assignment copies them.

    Attributes:
        parameters: parameters of the running function, empty outside functions; they hide globals of the same name.
        version: counts changes, for observers.
    """

    def __init__(self) -> None:
        self._everybodys: Names = {}
        self.parameters: Names = {}
        self.version = 0
        self._memory = 0

    def get(self, name: str) -> Value:
        """The value of a name; a list without copying. Raises RunFailureError `unset_variable`."""
        names = self.parameters if name in self.parameters else self._everybodys
        try:
            return names[name]
        except KeyError:
            raise RunFailureError("unset_variable", name=name) from None

    def set(self, name: str, value: Value) -> None:
        """Assigns a value. Raises RunFailureError `too_many_variables` or `memory_full`."""
        names = self.parameters if name in self.parameters else self._everybodys
        old = names.get(name)
        if old is None and len(names) >= MAX_VARIABLES:
            raise RunFailureError("too_many_variables", value=len(names) + 1, max=MAX_VARIABLES)
        if value.__class__ is list or value.__class__ is str or old.__class__ in (list, str):
            self._grow(size(value) - (0 if old is None else size(old)))
        names[name] = value.copy() if isinstance(value, list) else value
        self.version += 1

    def append(self, name: str, value: Value) -> None:
        """Appends to a list.

        Raises RunFailureError `unset_variable`, `wrong_type_list`, `list_in_list`, `list_too_long`, `memory_full`.
        """
        items = self._list(name, value)
        if len(items) >= MAX_LIST:
            raise RunFailureError("list_too_long", value=len(items) + 1, max=MAX_LIST)
        self._grow(1 + size(value))
        items.append(value)
        self.version += 1

    def replace_item(self, name: str, position: int, value: Value) -> None:
        """Replaces an item of a list; the first has the position 1.

        Raises RunFailureError `unset_variable`, `wrong_type_list`, `list_in_list`, `list_empty`, `index_out_of_range`,
        `memory_full`.
        """
        items = self._list(name, value)
        if not items:
            raise RunFailureError("list_empty", operator="replace_item")
        if not 1 <= position <= len(items):
            raise RunFailureError("index_out_of_range", value=position, min=1, max=len(items))
        self._grow(size(value) - size(items[position - 1]))
        items[position - 1] = value
        self.version += 1

    def _list(self, name: str, value: Value) -> list[Any]:
        """Returns the list of that name, to which the value will be added. Raises RunFailureError."""
        items = self.get(name)
        if not isinstance(items, list):
            raise RunFailureError("wrong_type_list", name=name)
        if isinstance(value, list):
            raise RunFailureError("list_in_list", name=name)
        return items

    def number(self, name: str) -> float:
        """The number of that name. Raises RunFailureError `unset_variable` or `wrong_type_number`."""
        value = self.get(name)
        if not isinstance(value, float):
            raise RunFailureError("wrong_type_number", name=name)
        return value

    def enter(self, parameters: Names) -> Names:
        """Enters a function; returns the caller's parameters, for `leave`."""
        outer, own = self.parameters, {}
        for name, value in parameters.items():
            self._grow(size(value))
            own[name] = value.copy() if isinstance(value, list) else value
        self.parameters = own
        self.version += 1
        return outer

    def leave(self, outer: Names) -> None:
        """Leaves the function: restores the caller's parameters."""
        self._memory -= sum(map(size, self.parameters.values()))
        self.parameters = outer
        self.version += 1

    def global_values(self) -> dict[str, Any]:
        """The globals as JSON data."""
        return {name: plain(value) for name, value in self._everybodys.items()}

    def visible(self) -> Names:
        """All visible names and their values; not to be modified."""
        return {**self._everybodys, **self.parameters}

    def _grow(self, more: int) -> None:
        if self._memory + more > MAX_MEMORY:
            raise RunFailureError("memory_full", max=MAX_MEMORY)
        self._memory += more
