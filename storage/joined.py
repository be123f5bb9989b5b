"""Lessons that were joined, as one tree each, whatever joins of several PCs have come together.

Each PC joins lessons by what it knows. Merged, a lesson may be a part of one that is itself a part of another, and two
may each be a part of the other: then the one with the smallest key stands for all.
"""

import sqlite3
from collections.abc import Mapping


def whole_of(db: sqlite3.Connection) -> dict[str, str]:
    """For each lesson that belongs to another the one that it belongs to in the end; others are not in it."""
    rows = db.execute(
        """SELECT part.id, part.part_of FROM lessons AS part JOIN lessons AS whole ON whole.id = part.part_of
           WHERE part.part_of != part.id"""
    )
    joined = {str(row["id"]): str(row["part_of"]) for row in rows}
    return {part: whole for part, whole in _ends(joined).items() if whole != part}


def tree_of(db: sqlite3.Connection, lesson_id: str) -> list[str]:
    """The whole that the lesson belongs to, then all its other parts by their keys."""
    wholes = whole_of(db)
    whole = wholes.get(lesson_id, lesson_id)
    return [whole, *sorted(part for part, of in wholes.items() if of == whole)]


def settle(db: sqlite3.Connection, lesson_id: str, now: str) -> None:
    """Writes the joins of the lesson's tree as they are shown, so that one of them can be changed."""
    whole, *parts = tree_of(db, lesson_id)
    wanted = [(whole, None), *((part, whole) for part in parts)]
    for part, of in wanted:
        db.execute(
            "UPDATE lessons SET part_of = ?, revision = revision + 1, changed_at = ? WHERE id = ? AND part_of IS NOT ?",
            [of, now, part, of],
        )


def _ends(joined: Mapping[str, str]) -> dict[str, str]:
    """Where the way from each lesson ends. Each step is gone once: a file from a stick may hold a chain without end."""
    ends: dict[str, str] = {}
    for start in joined:
        way: dict[str, None] = {}
        here = start
        while here in joined and here not in ends and here not in way:
            way[here] = None
            here = joined[here]
        if here in way:
            steps = list(way)
            end = min(steps[steps.index(here) :])
        else:
            end = ends.get(here, here)
        ends |= dict.fromkeys(way, end)
    return ends
