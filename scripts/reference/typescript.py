"""Converts plain data to TypeScript."""

import json
from typing import Any


def typescript(value: Any) -> str:
    """Returns a literal on one line."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key}: {typescript(part)}" for key, part in value.items()) + " }"
    if isinstance(value, list):
        return f"[{', '.join(map(typescript, value))}]"
    return f"{value:g}" if isinstance(value, float) else json.dumps(value)
