"""The tables of the file, each declared once, in the order of the content hash; rows of `LOCAL` stay on one PC.

Bundles, merging, deleting, the content hash, anonymous and Parquet exports, the view `about`, docs/database.md and
docs/parquet.md derive from these declarations; a test holds the tables that the migrations make against them.
The columns stand in the order of docs/parquet.md. The file has them in the order in which migrations added them.
"""

from storage.tables import rules
from storage.tables.columns import (
    KEY,
    REVISED,
    TEXT,
    Column,
    ReplicatedTable,
    numbered,
)
from storage.tables.local import LOCAL
from storage.tables.runs import EVENTS, RUNS, TELEMETRY
from storage.tables.work import (
    CLASS_PRESETS,
    CLASSROOMS,
    GROUPS,
    LABELS,
    LESSONS,
    NOTES,
    OWN_ACTIVITIES,
    PROGRAMS,
    TAUGHT_SIGNS,
    VERSIONS,
)

_USED = """id IN (
    SELECT computer_id FROM {schema}.versions UNION SELECT computer_id FROM {schema}.lessons
    UNION SELECT computer_id FROM {schema}.runs WHERE state <> 'running')"""

TOMBSTONES = ReplicatedTable(
    "tombstones",
    "Keys of what was deleted for good; nothing else is kept of it, and no merge brings it back.",
    (Column("id", KEY, "key of a row that was deleted"),),
    deletable=False,
    anonymous=False,
    parquet=False,
)
COMPUTERS = ReplicatedTable(
    "computers",
    "PCs whose work is in this file, by the name of the PC.",
    (
        Column("id", KEY, "key of a PC"),
        Column("name", TEXT, "its name", rules.name, numbered("computers", "PC")),
        *REVISED,
    ),
    condition=_USED,
    deletable=False,
)

# a row's parents stand before it; the content hash goes by this order
REPLICATED = (
    TOMBSTONES,
    COMPUTERS,
    CLASSROOMS,
    GROUPS,
    LESSONS,
    TAUGHT_SIGNS,
    OWN_ACTIVITIES,
    CLASS_PRESETS,
    PROGRAMS,
    VERSIONS,
    LABELS,
    RUNS,
    EVENTS,
    TELEMETRY,
    NOTES,
)
TABLES = {table.name: table for table in (*REPLICATED, *LOCAL)}
