"""The JSON Schema of world documents, made from the models.

`python -m sim.schema > sim/world.schema.json` writes the published file; a test holds it current. What no schema can
say (what crosses, what lies off the floor, whether the robot has room) is in docs/worlds.md.
"""

import json
from typing import Any

from sim.document import WorldDocument

_ID = "https://json-schema.org/draft/2020-12/schema"


def schema() -> dict[str, Any]:
    """The schema of a document."""
    made = WorldDocument.model_json_schema(mode="validation")
    return {"$schema": _ID, **made, "title": "PINEL world, version 1"}


def schema_text() -> str:
    """The schema as text, the same for the same models."""
    return json.dumps(schema(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    print(schema_text(), end="")
