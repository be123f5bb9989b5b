"""The migrations: SQL statements by name, in order. The first makes all tables; new ones are added at the end.

A bundle is refused if a definition in it differs from these statements. So a released statement never changes, not even
in its quotes. `work.py`, `runs.py`, `replicated.py` and `local.py` declare what a table means and what other modules
derive from it.

Rows that change in place have `revision`, which counts changes, and `changed_at`. Of two states of a row every merge
retains the greater one by revision, then time, then values, in any order of merges. For groups, lessons and notes the
revision counts the teacher's changes only. So changes by pupils, or by the app itself, never win over changes that
the teacher made on another PC meanwhile. Rows of other tables are only added. A row with a key in `tombstones` comes
back only if `deletions` has the key as retained.
"""

from storage.tables.views import VIEWS

_STATE = "revision INTEGER NOT NULL DEFAULT 1, changed_at TEXT NOT NULL DEFAULT ''"
_GROUPS_AND_PROGRAMS = (
    f"CREATE TABLE classrooms (id TEXT PRIMARY KEY, name TEXT NOT NULL, created_at TEXT NOT NULL, {_STATE}) STRICT",
    f"""CREATE TABLE "groups" (
        "id" TEXT PRIMARY KEY,
        "name" TEXT NOT NULL,
        "name_key" TEXT NOT NULL,
        "color" TEXT NOT NULL,
        "created_at" TEXT NOT NULL,
        "used_at" TEXT NOT NULL,
        classroom_id TEXT REFERENCES classrooms(id),
        picture TEXT NOT NULL DEFAULT '',
        {_STATE}
    ) STRICT""",
    "CREATE INDEX groups_classroom ON groups (classroom_id)",
    # not unique: two PCs may give one name to two groups, and both stay
    "CREATE INDEX groups_name_key ON groups (name_key)",
    f"""CREATE TABLE "programs" (
        "id" TEXT PRIMARY KEY,
        "group_id" TEXT NOT NULL REFERENCES "groups"("id"),
        "name" TEXT NOT NULL,
        "created_at" TEXT NOT NULL,
        "updated_at" TEXT NOT NULL,
        deleted_at TEXT,
        {_STATE}
    ) STRICT""",
    'CREATE INDEX "idx_programs_group_id_id" ON "programs" ("group_id", "id")',
    # parent_id has no foreign key: the version that was edited may be in a file that was never merged
    """CREATE TABLE "versions" (
        "id" TEXT PRIMARY KEY,
        "program_id" TEXT NOT NULL REFERENCES "programs"("id"),
        "number" INTEGER NOT NULL,
        "created_at" TEXT NOT NULL,
        "workspace" TEXT NOT NULL,
        "document" TEXT,
        "faults" TEXT NOT NULL,
        "world" TEXT,
        parent_id TEXT,
        lesson_id TEXT,
        computer_id TEXT,
        setup TEXT
    ) STRICT""",
    'CREATE INDEX "idx_versions_program_id_number" ON "versions" ("program_id", "number")',
    "CREATE INDEX versions_lesson ON versions (lesson_id)",
    f"CREATE TABLE version_labels (id TEXT PRIMARY KEY REFERENCES versions(id), text TEXT NOT NULL, {_STATE}) STRICT",
)
_RUNS = (
    """CREATE TABLE "runs" (
        "id" TEXT PRIMARY KEY,
        "group_id" TEXT REFERENCES "groups"("id"),
        "program_id" TEXT REFERENCES "programs"("id"),
        "program_name" TEXT,
        "version_id" TEXT REFERENCES "versions"("id"),
        "document" TEXT,
        "link" TEXT NOT NULL,
        "world" TEXT NOT NULL,
        "world_document" TEXT NOT NULL,
        "seed" INTEGER NOT NULL,
        "parameters" TEXT NOT NULL,
        "app_version" TEXT NOT NULL,
        "state" TEXT NOT NULL,
        "reason" TEXT,
        "params" TEXT,
        "block" TEXT,
        "started_at" TEXT NOT NULL,
        "ended_at" TEXT,
        "duration_s" REAL,
        "n_executed" INTEGER,
        "path_length_m" REAL,
        "closing_error_m" REAL,
        "summary" TEXT,
        "telemetry_sha256" TEXT,
        "path" TEXT,
        lesson_id TEXT,
        computer_id TEXT,
        activity TEXT,
        passed INTEGER,
        check_report TEXT
    ) STRICT""",
    'CREATE INDEX "idx_runs_group_id_id" ON "runs" ("group_id", "id")',
    'CREATE INDEX "idx_runs_program_id" ON "runs" ("program_id")',
    'CREATE INDEX "idx_runs_version_id" ON "runs" ("version_id")',
    "CREATE INDEX running ON runs (state) WHERE state = 'running'",
    "CREATE INDEX runs_lesson ON runs (lesson_id, id)",
    # the filters of the history use more columns than the group (storage/runs/history.py)
    "CREATE INDEX runs_history ON runs (id, group_id, lesson_id, activity, world, state, passed, started_at)",
    """CREATE TABLE "events" (
        "run_id" TEXT REFERENCES "runs"("id"),
        "seq" INTEGER,
        "tick" INTEGER NOT NULL,
        "type" TEXT NOT NULL,
        "data" TEXT NOT NULL,
        PRIMARY KEY ("run_id", "seq")
    ) STRICT""",
    """CREATE TABLE "telemetry" (
        "run_id" TEXT REFERENCES "runs"("id"),
        "chunk" INTEGER,
        "first_tick" INTEGER NOT NULL,
        "n_rows" INTEGER NOT NULL,
        "data" BLOB NOT NULL,
        PRIMARY KEY ("run_id", "chunk")
    ) STRICT""",
    f"""CREATE TABLE notes (
        id TEXT PRIMARY KEY,
        run_id TEXT NOT NULL REFERENCES runs(id),
        text TEXT NOT NULL,
        written_at TEXT NOT NULL,
        seen_at TEXT,
        {_STATE}
    ) STRICT""",
    "CREATE INDEX notes_run ON notes (run_id)",
)
_LESSONS = (
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
        {_STATE}
    ) STRICT""",
    "CREATE INDEX lessons_classroom ON lessons (classroom_id, opened_at)",
    """CREATE TABLE taught_signs (
        id TEXT PRIMARY KEY,
        classroom_id TEXT NOT NULL REFERENCES classrooms(id),
        sign TEXT NOT NULL,
        created_at TEXT NOT NULL,
        samples BLOB NOT NULL,
        is_moving INTEGER NOT NULL DEFAULT 0
    ) STRICT""",
    "CREATE INDEX taught_signs_classroom ON taught_signs (classroom_id, id)",
    f"""CREATE TABLE own_activities (
        id TEXT PRIMARY KEY,
        title TEXT NOT NULL,
        document TEXT NOT NULL,
        goal TEXT NOT NULL,
        created_at TEXT NOT NULL,
        deleted_at TEXT,
        {_STATE}
    ) STRICT""",
    f"""CREATE TABLE class_presets (
        id TEXT PRIMARY KEY REFERENCES classrooms(id), preset TEXT NOT NULL, {_STATE}
    ) STRICT""",
)
_COMPUTERS = (
    'CREATE TABLE "settings" ("key" TEXT PRIMARY KEY, "value" TEXT NOT NULL) STRICT',
    f"CREATE TABLE computers (id TEXT PRIMARY KEY, name TEXT NOT NULL, {_STATE}) STRICT",
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
    # releases before 0.3 signed bundles; nothing reads these two tables
    "CREATE TABLE signatures (public_key TEXT PRIMARY KEY, signature TEXT NOT NULL) STRICT, WITHOUT ROWID",
    """CREATE TABLE computer_keys (
        public_key TEXT PRIMARY KEY,
        computer_id TEXT NOT NULL,
        name TEXT NOT NULL,
        seen_at TEXT NOT NULL,
        approved_at TEXT
    ) STRICT, WITHOUT ROWID""",
    """CREATE TABLE unconfirmed_runs (
        run_id TEXT PRIMARY KEY, public_key TEXT, marked_at TEXT NOT NULL, finding TEXT
    ) STRICT, WITHOUT ROWID""",
    # stays on this PC: rows of a bundle get checksums when they are merged (storage/file/row_checksums.py)
    """CREATE TABLE content_sums (
        table_name TEXT NOT NULL,
        row_id TEXT NOT NULL,
        sha256 TEXT NOT NULL,
        damaged_at TEXT,
        PRIMARY KEY (table_name, row_id)
    ) STRICT, WITHOUT ROWID""",
    "CREATE INDEX content_sums_damaged ON content_sums (row_id) WHERE damaged_at IS NOT NULL",
    # rows retained in spite of a tombstone, and groups deleted with a class (storage/exchange/deleting/deletion.py)
    "CREATE TABLE deletions (id TEXT PRIMARY KEY, turn INTEGER NOT NULL, knew TEXT NOT NULL) STRICT, WITHOUT ROWID",
    """CREATE TABLE former_classes (
        group_id TEXT NOT NULL, classroom_id TEXT NOT NULL, has_left INTEGER NOT NULL,
        PRIMARY KEY (group_id, classroom_id)
    ) STRICT, WITHOUT ROWID""",
)
# each file has all of these names: the steps in which the tables developed before the first release
BASELINE = (
    "first_tables",
    "first_views",
    "worlds_of_versions",
    "classes_and_lessons",
    "history_index",
    "taught_signs",
    "setup_of_versions",
    "moving_signs",
    "world_in_history_index",
    "own_activities",
    "signed_bundles",
    "content_sums",
    "deletions",
    "marks_in_run_list",
)
MIGRATIONS: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(BASELINE, ()),
    BASELINE[0]: (
        *_GROUPS_AND_PROGRAMS,
        *_RUNS,
        *_LESSONS,
        *_COMPUTERS,
        *(f'CREATE VIEW "{name}" AS {select}' for name, select in VIEWS.items()),
    ),
    "robots_of_groups": (
        "ALTER TABLE groups ADD COLUMN robot_name TEXT NOT NULL DEFAULT ''",
        "ALTER TABLE groups ADD COLUMN robot_pattern TEXT NOT NULL DEFAULT ''",
    ),
    "truths_of_runs": (
        f"""CREATE TABLE truths (
            id TEXT PRIMARY KEY,
            run_id TEXT NOT NULL REFERENCES runs(id),
            source TEXT NOT NULL,
            poses TEXT NOT NULL,
            measured_at TEXT NOT NULL,
            {_STATE}
        ) STRICT""",
        "CREATE INDEX truths_run ON truths (run_id)",
    ),
    "calibrated_robots": (
        f"""CREATE TABLE calibrated_robots (
            id TEXT PRIMARY KEY,
            title TEXT NOT NULL,
            model TEXT NOT NULL,
            parameters TEXT NOT NULL,
            report TEXT NOT NULL,
            created_at TEXT NOT NULL,
            deleted_at TEXT,
            {_STATE}
        ) STRICT""",
    ),
}
