"""The JSON Schemas of program and world documents, generated from the models.

Rules that a schema cannot express are in docs/program-document.md (types of expressions, calls, jumps, depth) and
docs/worlds.md (crossing walls, parts outside the floor, a blocked start).
"""

import json
from typing import Any

from pinel_desktop.program.model import documents
from sim.document import WorldDocument

_ID = "https://json-schema.org/draft/2020-12/schema"


def of_programs() -> dict[str, Any]:
    """The schema of a program document in its normal form."""
    made = documents().json_schema(mode="validation")
    return {"$schema": _ID, **made, "title": "PINEL program document, version 1"}


def of_worlds() -> dict[str, Any]:
    """The schema of a world document."""
    made = WorldDocument.model_json_schema(mode="validation")
    return {"$schema": _ID, **made, "title": "PINEL world, version 1"}


def as_text(schema: dict[str, Any]) -> str:
    """A schema as JSON text; deterministic."""
    return json.dumps(schema, indent=2, sort_keys=True, ensure_ascii=False) + "\n"
