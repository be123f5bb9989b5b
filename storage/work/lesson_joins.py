"""Joined lessons as trees of one level, also after merges have combined the joins of several PCs.

Each PC joins the lessons that it has. After a merge, a lesson may be a part of a lesson that is itself a part of
another. Two lessons may also each be a part of the other. In such a cycle the lesson with the smallest key is the
root.
"""

from collections.abc import Mapping

from storage.sql import update_row
from storage.sqlite import sqlite3


def roots(db: sqlite3.Connection) -> dict[str, str]:
    """Returns the root of each lesson that is a part of another, without lessons that are no part."""
    rows = db.execute(
        """SELECT part.id, part.part_of FROM lessons AS part JOIN lessons AS whole ON whole.id = part.part_of
           WHERE part.part_of != part.id"""
    )
    joined = {str(row["id"]): str(row["part_of"]) for row in rows}
    return {part: whole for part, whole in _ends(joined).items() if whole != part}


def tree_of(db: sqlite3.Connection, lesson_id: str) -> list[str]:
    """Returns the root of the lesson's tree, then all parts in the order of their keys."""
    by_part = roots(db)
    root = by_part.get(lesson_id, lesson_id)
    return [root, *sorted(part for part, of in by_part.items() if of == root)]


def flatten(db: sqlite3.Connection, lesson_id: str, now: str) -> None:
    """Makes all joins of the lesson's tree point to its root, so that one of them can be changed."""
    root, *parts = tree_of(db, lesson_id)
    desired = [(root, None), *((part, root) for part in parts)]
    for part, of in desired:
        row = db.execute("SELECT part_of FROM lessons WHERE id = ?", [part]).fetchone()
        if row and row["part_of"] != of:
            update_row(db, "lessons", part, {"part_of": of}, now)


def _ends(joined: Mapping[str, str]) -> dict[str, str]:
    """Returns the end of the chain from each lesson. Visits each once, as a bundle may have a chain without end."""
    ends: dict[str, str] = {}
    for start in joined:
        chain: dict[str, None] = {}
        lesson = start
        while lesson in joined and lesson not in ends and lesson not in chain:
            chain[lesson] = None
            lesson = joined[lesson]
        if lesson in chain:
            visited = list(chain)
            end = min(visited[visited.index(lesson) :])
        else:
            end = ends.get(lesson, lesson)
        ends |= dict.fromkeys(chain, end)
    return ends
