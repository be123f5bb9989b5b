"""Tables of classes, lessons and what is said of work: the second part of `schema`.

Rows that are changed in place carry `revision`, which counts their changes, and `changed_at`: of two states of a row
the greater one (revision, then time, then content) is kept in every merge, whichever comes first. Of groups, lessons
and notes the revision counts the teacher's changes only: what pupils change, and what happens by itself, does not beat
what the teacher changed elsewhere meanwhile. All other rows are
only ever added. A key in `tombstones` is never brought back.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sqlite_utils import Database

# tables -> what `about` says of them
MEANINGS = {
    "classrooms": "Classes of the school. revision and changed_at decide which state of a row a merge keeps.",
    "lessons": "One meeting of a class: opened by the teacher, or by_itself when a group began to work. part_of names"
    " the lesson that the teacher has joined it to; activity what was to be solved.",
    "notes": "What the teacher has written about a run; seen_at when the group has read it.",
    "version_labels": "Names that a group has given to versions worth keeping.",
    "computers": "PCs whose work is in this file, by the name of the PC.",
    "tombstones": "Keys of what was deleted for good; nothing else is kept of it, and no merge brings it back.",
    "merges": "Files that were merged into this one, on this PC.",
    "exports": "Files that were written from this one, on this PC: what is deleted here may still be in them.",
}

_CHANGES = "revision INTEGER NOT NULL DEFAULT 1, changed_at TEXT NOT NULL DEFAULT ''"
_TABLES = (
    f"CREATE TABLE classrooms (id TEXT PRIMARY KEY, name TEXT NOT NULL, created_at TEXT NOT NULL, {_CHANGES}) STRICT",
    f"""CREATE TABLE lessons (
        id TEXT PRIMARY KEY,
        classroom_id TEXT REFERENCES classrooms(id),
        title TEXT NOT NULL,
        activity TEXT,
        by_itself INTEGER NOT NULL,
        computer_id TEXT NOT NULL,
        opened_at TEXT NOT NULL,
        used_at TEXT NOT NULL,
        closed_at TEXT,
        part_of TEXT,
        {_CHANGES}
    ) STRICT""",
    f"""CREATE TABLE notes (
        id TEXT PRIMARY KEY,
        run_id TEXT NOT NULL REFERENCES runs(id),
        text TEXT NOT NULL,
        written_at TEXT NOT NULL,
        seen_at TEXT,
        {_CHANGES}
    ) STRICT""",
    f"CREATE TABLE version_labels (id TEXT PRIMARY KEY REFERENCES versions(id), text TEXT NOT NULL, {_CHANGES}) STRICT",
    f"CREATE TABLE computers (id TEXT PRIMARY KEY, name TEXT NOT NULL, {_CHANGES}) STRICT",
    "CREATE TABLE tombstones (id TEXT PRIMARY KEY) STRICT, WITHOUT ROWID",
    """CREATE TABLE merges (
        id TEXT PRIMARY KEY,
        computer_id TEXT NOT NULL,
        computer_name TEXT NOT NULL,
        file TEXT NOT NULL,
        checksum TEXT NOT NULL,
        exported_at TEXT NOT NULL,
        merged_at TEXT NOT NULL,
        added TEXT NOT NULL
    ) STRICT""",
    """CREATE TABLE exports (
        id TEXT PRIMARY KEY, path TEXT NOT NULL, made_at TEXT NOT NULL, content TEXT NOT NULL
    ) STRICT""",
)
_COLUMNS = {
    "groups": (
        "classroom_id TEXT REFERENCES classrooms(id)",
        "picture TEXT NOT NULL DEFAULT ''",
        "revision INTEGER NOT NULL DEFAULT 1",
        "changed_at TEXT NOT NULL DEFAULT ''",
    ),
    "programs": (
        "deleted_at TEXT",  # in the bin since
        "revision INTEGER NOT NULL DEFAULT 1",
        "changed_at TEXT NOT NULL DEFAULT ''",
    ),
    # parent_id: the version that was edited; no foreign key, as it may be in a file that was never merged
    "versions": ("parent_id TEXT", "lesson_id TEXT", "computer_id TEXT"),
    "runs": (
        "lesson_id TEXT",
        "computer_id TEXT",
        "activity TEXT",
        "passed INTEGER",
        "check_report TEXT",
    ),
}
_INDEXES = (
    "CREATE INDEX groups_classroom ON groups (classroom_id)",
    "CREATE INDEX groups_name_key ON groups (name_key)",
    "CREATE INDEX lessons_classroom ON lessons (classroom_id, opened_at)",
    "CREATE INDEX versions_lesson ON versions (lesson_id)",
    "CREATE INDEX runs_lesson ON runs (lesson_id, id)",
    "CREATE INDEX notes_run ON notes (run_id)",
)


def make_class_tables(db: "Database") -> None:
    """Adds them, and what older tables need to go with them."""
    for table in _TABLES:
        db.execute(table)
    for name, columns in _COLUMNS.items():
        for column in columns:
            db.execute(f"ALTER TABLE {name} ADD COLUMN {column}")
    # two PCs may have given one name to two groups: both are kept
    db.execute("DROP INDEX idx_groups_name_key")
    for index in _INDEXES:
        db.execute(index)


def make_class_views(db: "Database") -> None:
    """The content with plain names, and of the older views those that can tell more now."""
    for name, select in _VIEWS.items():
        db.create_view(name, select, replace=True)


_VIEWS = {
    "group_list": """
        SELECT classrooms.name AS class, groups.name, groups.color, groups.picture, groups.created_at, groups.used_at,
               (SELECT count(*) FROM programs WHERE group_id = groups.id AND deleted_at IS NULL) AS programs,
               (SELECT count(*) FROM runs WHERE group_id = groups.id) AS runs
        FROM groups LEFT JOIN classrooms ON classrooms.id = groups.classroom_id ORDER BY groups.used_at DESC""",
    "program_list": """
        SELECT classrooms.name AS class, groups.name AS "group", programs.name AS program, programs.created_at,
               programs.updated_at, programs.deleted_at,
               (SELECT count(*) FROM versions WHERE program_id = programs.id) AS versions
        FROM programs JOIN groups ON groups.id = programs.group_id
             LEFT JOIN classrooms ON classrooms.id = groups.classroom_id
        ORDER BY programs.id DESC""",
    "run_list": """
        SELECT runs.id, classrooms.name AS class, groups.name AS "group", lessons.title AS lesson,
               runs.program_name AS program, runs.world, runs.state, runs.reason, runs.activity, runs.passed,
               runs.started_at, runs.duration_s, runs.path_length_m, runs.closing_error_m,
               computers.name AS computer
        FROM runs LEFT JOIN groups ON groups.id = runs.group_id
             LEFT JOIN classrooms ON classrooms.id = groups.classroom_id
             LEFT JOIN lessons ON lessons.id = runs.lesson_id
             LEFT JOIN computers ON computers.id = runs.computer_id
        ORDER BY runs.id DESC""",
    "lesson_list": """
        SELECT classrooms.name AS class, lessons.title, lessons.activity, lessons.by_itself, lessons.opened_at,
               lessons.closed_at, computers.name AS computer, joined.title AS part_of,
               (SELECT count(*) FROM versions WHERE lesson_id = lessons.id) AS edits,
               (SELECT count(*) FROM runs WHERE lesson_id = lessons.id) AS runs
        FROM lessons LEFT JOIN classrooms ON classrooms.id = lessons.classroom_id
             LEFT JOIN computers ON computers.id = lessons.computer_id
             LEFT JOIN lessons AS joined ON joined.id = lessons.part_of
        ORDER BY lessons.opened_at DESC""",
    "version_list": """
        SELECT groups.name AS "group", programs.name AS program, versions.number, version_labels.text AS label,
               versions.created_at, versions.document IS NOT NULL AS can_run, lessons.title AS lesson
        FROM versions JOIN programs ON programs.id = versions.program_id
             JOIN groups ON groups.id = programs.group_id
             LEFT JOIN version_labels ON version_labels.id = versions.id
             LEFT JOIN lessons ON lessons.id = versions.lesson_id
        ORDER BY versions.id DESC""",
    "note_list": """
        SELECT groups.name AS "group", runs.program_name AS program, runs.started_at AS run, notes.text,
               notes.written_at, notes.seen_at
        FROM notes JOIN runs ON runs.id = notes.run_id LEFT JOIN groups ON groups.id = runs.group_id
        ORDER BY notes.written_at DESC""",
}
