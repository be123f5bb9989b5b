"""Generates, from the declarations of checks, the fields of the page's form and the table of docs/activities.md."""

from dataclasses import asdict
from inspect import getdoc
from typing import Any

from pinel_desktop.activities.checks import KINDS
from pinel_desktop.activities.checks.base import CheckBase, FormField
from pinel_desktop.activities.checks.run.any_of import AnyOf
from scripts.reference.typescript import typescript

_HEAD = """\
// Made by `python -m scripts.reference` from pinel_desktop/activities/checks/. Do not edit.

/** What the teacher chooses of each kind of check that the form offers, in its order. */
export const CHECK_FIELDS = {
"""


def check_fields() -> str:
    """Returns the text of `ui/src/teacher/making/check_fields.ts`."""
    rows = [
        f"  {name}: {typescript([_field(one) for one in kind.form])},\n"
        for name, kind in KINDS.items()
        if kind.form is not None
    ]
    return "".join([_HEAD, *rows, "} as const;\n"])


def _field(field: FormField) -> dict[str, Any]:
    """Removes the attributes that a field of this kind of input does not use."""
    if field.input == "number":
        names = {"key", "input", "label", "min", "max", "step", "factor"}
    else:
        names = {"key", "input"} | ({"value"} if field.input == "fixed" else set())
    return {name: value for name, value in asdict(field).items() if name in names}


def checks_of_activities() -> list[str]:
    """Returns the table of docs/activities.md."""
    rows = [f"| `{name}` | {_holds(kind)} | {_on_robot(kind)} |" for name, kind in KINDS.items()]
    return ["| check | holds when | on a real robot |", "|---|---|---|", *rows]


def _holds(kind: type[CheckBase]) -> str:
    text = " ".join((getdoc(kind) or "").split()).removesuffix(".")
    return text[0].lower() + text[1:]


def _on_robot(kind: type[CheckBase]) -> str:
    if kind is AnyOf:
        return "as its checks"
    return f"no: {kind.requires}" if kind.requires else "yes"
