"""The tables of the file, declared once: those whose rows go from PC to PC, and those that stay on one.

Bundles, merging, deleting, the content hash, anonymous and Parquet exports, the view `about`, docs/database.md and
docs/parquet.md derive from these declarations; a test holds the tables that the migrations make against them.
The columns stand in the order of docs/parquet.md. The file has them in the order in which migrations added them.
"""

from storage.choices import PICTURES
from storage.limits import (
    MAX_NAME,
    MAX_NOTE,
    MAX_NUMBER,
    MAX_REVISION,
    MAX_SAMPLES,
    N_FEATURES,
)
from storage.tables import rules
from storage.tables.columns import (
    BLOB,
    COUNT,
    FLAG,
    JSON,
    KEPT,
    KEY,
    NUMBER,
    TEXT,
    TIME,
    Column,
    ReplicatedTable,
    Table,
    figure,
    numbered,
    parent,
    reference,
)

_ENDED = "run_id NOT IN (SELECT id FROM {schema}.runs WHERE state = 'running')"
_USED = """id IN (
    SELECT computer_id FROM {schema}.versions UNION SELECT computer_id FROM {schema}.lessons
    UNION SELECT computer_id FROM {schema}.runs WHERE state <> 'running')"""
# rows that are changed in place
_STATE = (
    Column(
        "revision",
        COUNT,
        "counts changes; of two states of a row the greater is kept",
        rules.whole(1, MAX_REVISION),
        parquet=False,
    ),
    Column(
        "changed_at",
        TIME,
        "when it was changed; decides between states of one revision",
        rules.time_or_empty,
        parquet=False,
    ),
)
_PROGRAM_NAME = """CASE WHEN program_name IS NULL THEN NULL ELSE
    coalesce((SELECT name FROM programs WHERE programs.id = program_id), 'Programa') END"""

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
        *_STATE,
    ),
    condition=_USED,
    deletable=False,
)
CLASSROOMS = ReplicatedTable(
    "classrooms",
    "Classes of the school. revision and changed_at decide which state of a row a merge keeps.",
    (
        Column("id", KEY, "key of a class"),
        Column("name", TEXT, "its name", rules.name, numbered("classrooms", "Turma")),
        Column("created_at", TIME, "when it was made"),
        *_STATE,
    ),
    own_tombstone=True,
)
GROUPS = ReplicatedTable(
    "groups",
    "Pupils who work together. name_key is the name without spaces and case; used_at orders the list.",
    (
        Column("id", KEY, "key of a group of pupils"),
        parent("classroom_id", "classrooms", "its class", optional=True),
        Column("name", TEXT, "its name", rules.name, numbered("groups", "Grupo")),
        Column(
            "name_key",
            TEXT,
            "the name without spaces and case",
            rules.line(20 * MAX_NAME),
            f"name_key({numbered('groups', 'Grupo')})",
            parquet=False,
        ),
        Column("color", TEXT, "its colour", rules.color, KEPT, parquet=False),
        Column("picture", TEXT, "its picture", rules.one_of("", *PICTURES), KEPT, parquet=False),
        Column("created_at", TIME, "when it was made"),
        Column("used_at", TIME, "when it last worked"),
        *_STATE,
    ),
    own_tombstone=True,
)
LESSONS = ReplicatedTable(
    "lessons",
    "One meeting of a class: opened by the teacher, or by_itself when a group began to work. part_of names"
    " the lesson that the teacher has joined it to; activity what was to be solved.",
    (
        Column("id", KEY, "key of a lesson"),
        parent("classroom_id", "classrooms", "its class", optional=True),
        reference("computer_id", "computers", "PC on which it was opened last", optional=False),
        Column(
            "title",
            TEXT,
            "its title, empty where it opened by itself",
            rules.title,
            f"CASE title WHEN '' THEN '' ELSE {numbered('lessons', 'Aula')} END",
        ),
        Column(
            "activity", TEXT, "what was to be solved", rules.short, "plain(activity)", optional=True
        ),
        Column("by_itself", FLAG, "opened when a group began to work, not by the teacher"),
        reference("part_of", "lessons", "the lesson that it was joined to"),
        Column("opened_at", TIME, "when it began"),
        Column("closed_at", TIME, "when it ended", optional=True),
        Column("used_at", TIME, "when a group last worked in it", parquet=False),
        *_STATE,
    ),
    own_tombstone=True,
)
TAUGHT_SIGNS = ReplicatedTable(
    "taught_signs",
    "Signs that a class has shown the camera: one row for each time that one was recorded, never changed. The samples"
    " are landmarks of children's hands: anonymous and Parquet exports leave them out, as do the files of a group and"
    " of a program.",
    (
        Column("id", KEY, "key of a recording of a sign"),
        parent("classroom_id", "classrooms", "the class that taught it"),
        Column(
            "sign", TEXT, "its name: a letter, or a word of the class", rules.sign, "plain(sign)"
        ),
        Column("created_at", TIME, "when it was recorded"),
        Column(
            "samples",
            BLOB,
            f"hands that show it: rows of {N_FEATURES} features as float16, little-endian",
            rules.hands,
        ),
    ),
    own_tombstone=True,
    anonymous=False,
    parquet=False,
)
PROGRAMS = ReplicatedTable(
    "programs",
    "Saved blocks of a group; the content is in versions.",
    (
        Column("id", KEY, "key of a program"),
        parent("group_id", "groups", "its group"),
        Column("name", TEXT, "its name", rules.name, numbered("programs", "Programa")),
        Column("created_at", TIME, "when it was made"),
        Column("updated_at", TIME, "when it was last edited"),
        Column("deleted_at", TIME, "in the bin since", optional=True),
        *_STATE,
    ),
    own_tombstone=True,
)
VERSIONS = ReplicatedTable(
    "versions",
    "Every state of a program, never overwritten; number counts within the program. workspace is"
    " what the editor shows, document what the robot gets (null while faults is not empty), world the group's own"
    " (null where it is chosen by name).",
    (
        Column("id", KEY, "key of a state of a program"),
        parent("program_id", "programs", "its program"),
        reference("parent_id", "versions", "the version that was edited"),
        reference("lesson_id", "lessons", "lesson in which it was saved"),
        reference("computer_id", "computers", "PC on which it was saved"),
        Column(
            "number",
            COUNT,
            "its place among the versions of the program",
            rules.whole(1, MAX_NUMBER),
        ),
        Column("created_at", TIME, "when it was saved"),
        Column(
            "workspace", JSON, "the blocks in the editor", rules.workspace, "'{}'", parquet=False
        ),
        Column(
            "document",
            JSON,
            "what the robot gets, as JSON (program-document.md); null while it has faults",
            optional=True,
        ),
        Column(
            "faults",
            JSON,
            "what is wrong with it",
            rules.faults,
            """CASE faults WHEN '[]' THEN '[]' ELSE '[["anonymous","",null,{}]]' END""",
            parquet=False,
        ),
        Column("world", JSON, "the group's own world", rules.world, optional=True, parquet=False),
    ),
    figures=(figure("n_faults", "how many faults it has", "json_array_length(faults)"),),
)
LABELS = ReplicatedTable(
    "version_labels",
    "Names that a group has given to versions worth keeping.",
    (
        parent("id", "versions", "key of the version"),
        Column("text", TEXT, "its name", rules.title, "plain(text)"),
        *_STATE,
    ),
    anonymous=False,
    parquet=False,
)
RUNS = ReplicatedTable(
    "runs",
    "One execution of a version (or, from the command line, of document) in a world.",
    (
        Column("id", KEY, "key of an execution"),
        parent("group_id", "groups", "its group, null from the command line", optional=True),
        parent("program_id", "programs", "its program", optional=True),
        parent("version_id", "versions", "its version", optional=True),
        reference("lesson_id", "lessons", "lesson in which it ran"),
        reference("computer_id", "computers", "PC on which it ran"),
        Column(
            "program_name",
            TEXT,
            "name of the program when it ran",
            rules.lines(rules.MAX_TEXT),
            _PROGRAM_NAME,
            optional=True,
            parquet=False,
        ),
        Column(
            "document", JSON, "the program of a run without version", optional=True, parquet=False
        ),
        Column("link", TEXT, "robot: `sim` is the simulator", rules.short, KEPT),
        Column(
            "world",
            TEXT,
            "name of the world, `own` for one that the group made",
            rules.short,
            "plain(world)",
        ),
        Column("world_document", JSON, "the world itself", rules.world, parquet=False),
        Column("seed", COUNT, "of chance", rules.whole(-(2**63), 2**63 - 1), parquet=False),
        Column("parameters", JSON, "settings of the run", parquet=False),
        Column(
            "activity", TEXT, "what was to be solved", rules.short, "plain(activity)", optional=True
        ),
        Column("passed", FLAG, "whether it was; null where nothing was checked", optional=True),
        Column("check_report", JSON, "what the check found", optional=True, parquet=False),
        Column(
            "state",
            TEXT,
            "`finished`, `stopped` or `failed`",
            rules.one_of("finished", "stopped", "failed"),
            KEPT,
        ),
        Column("reason", TEXT, "why it ended so, as a code", rules.word, KEPT, optional=True),
        Column("params", JSON, "what fills the words of the reason", optional=True, parquet=False),
        Column(
            "block",
            TEXT,
            "key of the block at which it ended",
            rules.block,
            "plain(block)",
            optional=True,
            parquet=False,
        ),
        Column("started_at", TIME, "when it began"),
        Column("ended_at", TIME, "when it ended", optional=True),
        Column("duration_s", NUMBER, "how long it ran, in s", optional=True),
        Column("n_executed", COUNT, "commands executed", optional=True),
        Column("path_length_m", NUMBER, "length of the way, in m", optional=True),
        Column("closing_error_m", NUMBER, "distance between start and end, in m", optional=True),
        Column("summary", JSON, "other figures of its end", optional=True, parquet=False),
        Column(
            "telemetry_sha256",
            TEXT,
            "SHA-256 of its samples, in hex",
            rules.sha256,
            KEPT,
            optional=True,
            parquet=False,
        ),
        Column(
            "path",
            JSON,
            "points of its picture, in m",
            rules.points,
            KEPT,
            optional=True,
            parquet=False,
        ),
        Column("app_version", TEXT, "release that ran it", rules.short, KEPT),
    ),
    condition="state <> 'running'",
    figures=(
        figure(
            "n_events", "events recorded", "(SELECT count(*) FROM events WHERE run_id = runs.id)"
        ),
        figure(
            "n_samples",
            "samples recorded, 30 a second",
            "(SELECT coalesce(sum(n_rows), 0) FROM telemetry WHERE run_id = runs.id)",
        ),
    ),
    # a run that was cut off, as in a backup that came back, is earlier than one that has ended
    later_by=("{side}.reason IS NOT 'interrupted'", "coalesce({side}.duration_s, 0)"),
)
EVENTS = ReplicatedTable(
    "events",
    "What happened in a run, by seq; tick / 30 is the time in s; data holds the other fields.",
    (
        parent("run_id", "runs", "its run"),
        Column("seq", COUNT, "place among the events and samples of the run"),
        Column("tick", COUNT, "when it happened, in steps of 1/30 s"),
        Column("type", TEXT, "the type of event", rules.word, KEPT),
        Column("data", JSON, "the other fields of the event"),
    ),
    key=("run_id", "seq"),
    condition=_ENDED,
    parquet=False,
)
TELEMETRY = ReplicatedTable(
    "telemetry",
    "Samples of a run at 30 Hz in chunks: zlib of byte-shuffled int32 differences, column by"
    " column; steps in storage/runs/telemetry.py.",
    (
        parent("run_id", "runs", "its run"),
        Column("chunk", COUNT, "place of the chunk in the run"),
        Column("first_tick", COUNT, "when it begins, in steps of 1/30 s"),
        Column("n_rows", COUNT, "samples in it", rules.whole(1, MAX_SAMPLES)),
        Column("data", BLOB, "the samples, packed"),
    ),
    key=("run_id", "chunk"),
    condition=_ENDED,
    parquet=False,
)
NOTES = ReplicatedTable(
    "notes",
    "What the teacher has written about a run; seen_at when the group has read it.",
    (
        Column("id", KEY, "key of a note"),
        parent("run_id", "runs", "the run that it is about"),
        Column("text", TEXT, "what the teacher wrote", rules.lines(MAX_NOTE), "plain(text)"),
        Column("written_at", TIME, "when it was written"),
        Column("seen_at", TIME, "when the group read it", optional=True),
        *_STATE,
    ),
    condition=_ENDED,
    anonymous=False,
    parquet=False,
)

# a row's parents stand before it; the content hash goes by this order
REPLICATED = (
    TOMBSTONES,
    COMPUTERS,
    CLASSROOMS,
    GROUPS,
    LESSONS,
    TAUGHT_SIGNS,
    PROGRAMS,
    VERSIONS,
    LABELS,
    RUNS,
    EVENTS,
    TELEMETRY,
    NOTES,
)
LOCAL = (
    Table(
        "settings",
        "What was chosen, as JSON.",
        (
            Column("key", TEXT, "name of the setting", rules.short, KEPT),
            Column("value", JSON, "what was chosen"),
        ),
        key=("key",),
    ),
    Table(
        "merges",
        "Files that were merged into this one, on this PC.",
        (
            Column("id", KEY, "key of a merge"),
            Column("computer_id", KEY, "PC that wrote the file"),
            Column("computer_name", TEXT, "its name then", rules.name, KEPT),
            Column("file", TEXT, "name of the file", rules.short, KEPT),
            Column("checksum", TEXT, "content hash of the file", rules.sha256, KEPT),
            Column("exported_at", TIME, "when the file was written"),
            Column("merged_at", TIME, "when it was merged"),
            Column("added", JSON, "rows that it brought, by table"),
        ),
    ),
    Table(
        "exports",
        "Files that were written from this one, on this PC: what is deleted here may still be in them.",
        (
            Column("id", KEY, "key of an export"),
            Column("path", TEXT, "where the file was written", rules.short, KEPT),
            Column("made_at", TIME, "when it was written"),
            Column("content", JSON, "its checksum, what it is of, and how many runs are in it"),
        ),
    ),
)
TABLES = {table.name: table for table in (*REPLICATED, *LOCAL)}
