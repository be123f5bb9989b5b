"""The JSON Schema of the program document, made from the models.

What no schema can say (types of expressions, calls, jumps, depth) is in docs/program-document.md.
"""

import json
from typing import Any

from pinel_desktop.program.model import documents

_ID = "https://json-schema.org/draft/2020-12/schema"


def schema() -> dict[str, Any]:
    """The schema of a document in its normal form."""
    made = documents().json_schema(mode="validation")
    return {"$schema": _ID, **made, "title": "PINEL program document, version 1"}


def schema_text() -> str:
    """The schema as text, the same for the same models."""
    return json.dumps(schema(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"
