"""Version vectors: how far the deleting PC has the work of a row, so that other PCs find the newer work.

For each PC, the vector of a group or program has the newest key of its versions and runs. The keys of one PC grow.
The vector of a group also has its class.
"""

from collections.abc import Collection, Iterator
from typing import Any

from storage.sql import tuples
from storage.sqlite import sqlite3
from storage.text import to_json

# group, program, PC and newest key
_NEWEST = """
    SELECT programs.group_id, programs.id, coalesce(computer_id, ''), max(versions.id)
    FROM main.versions JOIN main.programs ON programs.id = program_id GROUP BY 2, 3
    UNION ALL
    SELECT group_id, program_id, coalesce(computer_id, ''), max(id) FROM main.runs GROUP BY 1, 2, 3"""


def version_vectors(db: sqlite3.Connection, ids: Collection[str]) -> Iterator[tuple[str, str]]:
    """Yields key and version vector, as `deletions.knew` stores it, of the groups and programs among the keys."""
    rows = "SELECT id, classroom_id FROM main.groups UNION ALL SELECT id, NULL FROM main.programs"
    found = {str(key): classroom for key, classroom in tuples(db, rows) if key in ids}
    if not found:
        return
    newest: dict[str, dict[str, str]] = {key: {} for key in found}
    for group_id, program_id, computer_id, last in tuples(db, _NEWEST):
        for key in (group_id, program_id):
            if key in newest:
                newest[key][computer_id] = max(last, newest[key].get(computer_id, ""))
    for key, classroom in sorted(found.items()):
        of_pcs = {"newest": dict(sorted(newest[key].items()))}
        version_vector: dict[str, Any] = {"classroom": classroom} if classroom else {}
        yield key, to_json(version_vector | of_pcs)
