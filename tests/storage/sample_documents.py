"""A program and a world in stored form."""

from typing import Any

WORLD: dict[str, Any] = {"pinel_world": 1, "name": "empty_room"}
SQUARE: dict[str, Any] = {
    "pinel_ir": 1,
    "name": "square",
    "functions": [],
    "commands": [{"action": "repeat", "times": 4, "commands": []}],
}
