"""Declarations of the tables of `storage/work/`; `replicated.py` has their order."""

from storage.choices import PATTERNS, PICTURES
from storage.limits import MAX_NAME, MAX_NOTE, MAX_NUMBER, N_FEATURES
from storage.tables import rules
from storage.tables.columns import (
    BLOB,
    COUNT,
    ENDED,
    FLAG,
    JSON,
    KEY,
    REVISED,
    TEXT,
    TIME,
    UNCHANGED,
    Column,
    ReplicatedTable,
    metric,
    numbered,
    parent,
    reference,
)

CLASSROOMS = ReplicatedTable(
    "classrooms",
    "Classes of the school. revision and changed_at decide which state of a row a merge keeps.",
    (
        Column("id", KEY, "key of a class"),
        Column("name", TEXT, "its name", rules.name, numbered("classrooms", "Turma")),
        Column("created_at", TIME, "when it was made"),
        *REVISED,
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
        Column("color", TEXT, "its colour", rules.color, UNCHANGED, parquet=False),
        Column(
            "picture", TEXT, "its picture", rules.one_of("", *PICTURES), UNCHANGED, parquet=False
        ),
        Column(
            "robot_name",
            TEXT,
            "the name of its robot, empty where the robot has the group's name",
            rules.title,
            "''",
            parquet=False,
            counts_empty=False,
        ),
        Column(
            "robot_pattern",
            TEXT,
            "the pattern of its robot",
            rules.one_of("", *PATTERNS),
            UNCHANGED,
            parquet=False,
            counts_empty=False,
        ),
        Column("created_at", TIME, "when it was made"),
        Column("used_at", TIME, "when it last worked"),
        *REVISED,
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
        *REVISED,
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
            f"hands that show it: rows of {N_FEATURES} numbers as float16, little-endian; of each the features of a"
            " hand at rest, or a movement",
            rules.hands,
        ),
        Column("is_moving", FLAG, "whether the samples are movements"),
    ),
    own_tombstone=True,
    anonymous=False,
    parquet=False,
)
OWN_ACTIVITIES = ReplicatedTable(
    "own_activities",
    "Activities that a teacher made. document is the activity (activities.md) with its solution, goal what the picture"
    " of its goal shows. Lessons, runs and versions name one by its key, so that one deleted is only marked.",
    (
        Column("id", KEY, "key of an activity"),
        Column("title", TEXT, "its title", rules.name, "plain(title)"),
        Column("document", JSON, "the activity", rules.activity),
        Column("goal", JSON, "lines, zones and boxes of the picture of its goal", rules.goal),
        Column("created_at", TIME, "when it was made"),
        Column("deleted_at", TIME, "deleted since", optional=True),
        *REVISED,
    ),
    deletable=False,
    anonymous=False,
    parquet=False,
    counts_empty=False,
)
CALIBRATED_ROBOTS = ReplicatedTable(
    "calibrated_robots",
    "Robots of the simulator with the errors of a real one (calibration.md). Versions name one by its key, so that one"
    " deleted is only marked; runs hold its parameters.",
    (
        Column("id", KEY, "key of a calibrated robot"),
        Column("title", TEXT, "its name", rules.name, "plain(title)"),
        Column("model", TEXT, "name of the model that it differs from", rules.short, UNCHANGED),
        Column("parameters", JSON, "in what it differs, in SI units", rules.robot_parameters),
        Column(
            "report",
            JSON,
            "what the calibration found: runs, parameters with intervals and sources, predictions of runs held out",
            rules.json_object,
        ),
        Column("created_at", TIME, "when it was calibrated"),
        Column("deleted_at", TIME, "deleted since", optional=True),
        *REVISED,
    ),
    deletable=False,
    anonymous=False,
    parquet=False,
    counts_empty=False,
)
CLASS_PRESETS = ReplicatedTable(
    "class_presets",
    "With what the groups of a class begin: level, world, activity, minutes between swaps, album of stickers.",
    (
        parent("id", "classrooms", "key of the class"),
        Column(
            "preset",
            JSON,
            "level, world, activity, swap_minutes, album; what is missing is not set",
        ),
        *REVISED,
    ),
    anonymous=False,
    parquet=False,
    counts_empty=False,
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
        *REVISED,
    ),
    own_tombstone=True,
)
VERSIONS = ReplicatedTable(
    "versions",
    "Every state of a program, never overwritten; number counts within the program. workspace is"
    " what the editor shows, document what the robot gets (null while faults is not empty), world the group's own"
    " (null where it is chosen by name).",
    (
        Column(
            "id",
            KEY,
            "key of a state of a program, with bits of a hash of all that follows but number",
        ),
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
        Column(
            "setup",
            JSON,
            "where and how it runs: name of the world, start, robot setting, speed, activity",
            rules.json_object,
            optional=True,
            parquet=False,
        ),
    ),
    metrics=(metric("n_faults", "how many faults it has", "json_array_length(faults)"),),
    # the keys in files are hashes of just these columns, so no later column can be added
    bound=(
        *("program_id", "parent_id", "lesson_id", "computer_id", "created_at"),
        *("workspace", "document", "faults", "world", "setup"),
    ),
)
LABELS = ReplicatedTable(
    "version_labels",
    "Names that a group has given to versions worth keeping.",
    (
        parent("id", "versions", "key of the version"),
        Column("text", TEXT, "its name", rules.title, "plain(text)"),
        *REVISED,
    ),
    anonymous=False,
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
        *REVISED,
    ),
    condition=ENDED,
    anonymous=False,
    parquet=False,
)
