"""The replicated tables, each declared once, in the order of the content hash; rows of `LOCAL` stay on one PC.

Bundles, merging, deleting, the content hash, anonymous and Parquet exports, the view `about`, docs/database.md and
docs/parquet.md derive from these declarations. A test compares them with the tables that the migrations make. The
order of columns is the one of docs/parquet.md. In the file, columns are in the order in which migrations added them.
"""

from storage.limits import MAX_TURN
from storage.tables import rules
from storage.tables.columns import (
    COUNT,
    FLAG,
    JSON,
    KEY,
    REVISED,
    TEXT,
    Column,
    ReplicatedTable,
    numbered,
)
from storage.tables.local import LOCAL
from storage.tables.runs import EVENTS, RUNS, TELEMETRY, TRUTHS
from storage.tables.work import (
    CALIBRATED_ROBOTS,
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
    "Keys of what was deleted for good; no merge brings it back unless deletions says that it was kept elsewhere.",
    (Column("id", KEY, "key of a row that was deleted"),),
    deletable=False,
    anonymous=False,
    parquet=False,
)
DELETIONS = ReplicatedTable(
    "deletions",
    "What was decided about rows with a tombstone: turn counts the decisions, even for deleted, odd for kept, and the"
    " greatest is the one that holds. knew says how far the PC that deleted a row knew the work in it.",
    (
        Column("id", KEY, "key of a row that was deleted"),
        Column(
            "turn",
            COUNT,
            "even: deleted; odd: kept nevertheless",
            rules.whole(0, MAX_TURN),
        ),
        Column(
            "knew",
            JSON,
            "keys: classroom of the row, and by PC newest, the last version or run that was known",
            rules.version_vector,
        ),
    ),
    deletable=False,
    anonymous=False,
    parquet=False,
    counts_empty=False,
)
FORMER_CLASSES = ReplicatedTable(
    "former_classes",
    "Classes that a group was in before, and those in which another PC saw it: where one was deleted meanwhile, the"
    " group is deleted with it, unless it had left before.",
    (
        Column("group_id", KEY, "key of a group"),
        Column("classroom_id", KEY, "a class that it was in"),
        Column(
            "has_left", FLAG, "whether the group was known elsewhere when the class was deleted"
        ),
    ),
    key=("group_id", "classroom_id"),
    # without the class that the group is in now, and without groups that have a tombstone of their own
    condition="group_id NOT IN (SELECT id FROM {schema}.tombstones)"
    " AND (group_id, classroom_id) NOT IN (SELECT id, coalesce(classroom_id, '') FROM {schema}.groups)",
    deletable=False,
    anonymous=False,
    parquet=False,
    counts_empty=False,
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

# parents are before their children; the content hash follows this order
REPLICATED = (
    TOMBSTONES,
    DELETIONS,
    FORMER_CLASSES,
    COMPUTERS,
    CLASSROOMS,
    GROUPS,
    LESSONS,
    TAUGHT_SIGNS,
    OWN_ACTIVITIES,
    CALIBRATED_ROBOTS,
    CLASS_PRESETS,
    PROGRAMS,
    VERSIONS,
    LABELS,
    RUNS,
    EVENTS,
    TELEMETRY,
    NOTES,
    TRUTHS,
)
TABLES = {table.name: table for table in (*REPLICATED, *LOCAL)}
