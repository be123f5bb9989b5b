"""Declarations of the tables of `storage/runs/`; `replicated.py` has their order."""

from storage.choices import TRUTH_SOURCES
from storage.limits import MAX_SAMPLES
from storage.tables import rules
from storage.tables.columns import (
    BLOB,
    COUNT,
    ENDED,
    FLAG,
    JSON,
    KEY,
    NUMBER,
    REVISED,
    TEXT,
    TIME,
    UNCHANGED,
    Column,
    ParquetColumn,
    ReplicatedTable,
    metric,
    parent,
    reference,
)

_PROGRAM_NAME = """CASE WHEN program_name IS NULL THEN NULL ELSE
    coalesce((SELECT name FROM programs WHERE programs.id = program_id), 'Programa') END"""

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
        Column("link", TEXT, "robot: `sim` is the simulator", rules.short, UNCHANGED),
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
            UNCHANGED,
        ),
        Column(
            "reason", TEXT, "why it ended so, as a code", rules.identifier, UNCHANGED, optional=True
        ),
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
        Column(
            "closing_error_m",
            NUMBER,
            "distance between start and end, in m: where the robot truly was, empty where only its estimate exists; "
            "the estimate where no `estimated_closing_error_m` is beside it, as in runs of earlier releases",
            optional=True,
        ),
        Column(
            "summary",
            JSON,
            "all of its end, with `estimated_closing_error_m`: by the pose that the robot itself estimated",
            optional=True,
            parquet=False,
        ),
        Column(
            "telemetry_sha256",
            TEXT,
            "SHA-256 of its samples, in hex",
            rules.sha256,
            UNCHANGED,
            optional=True,
            parquet=False,
        ),
        Column(
            "path",
            JSON,
            "points of its picture, in m",
            rules.points,
            UNCHANGED,
            optional=True,
            parquet=False,
        ),
        Column("app_version", TEXT, "release that ran it", rules.short, UNCHANGED),
    ),
    condition="state <> 'running'",
    metrics=(
        ParquetColumn(
            "estimated_closing_error_m",
            "number",
            "distance between start and end, in m, by the pose that the robot itself estimated; empty before that was "
            "told beside the true one",
            """CASE WHEN NOT json_valid(summary) THEN NULL
            WHEN json_type(summary, '$.estimated_closing_error_m') IN ('integer', 'real')
            THEN json_extract(summary, '$.estimated_closing_error_m') END""",
        ),
        metric(
            "n_events", "events recorded", "(SELECT count(*) FROM events WHERE run_id = runs.id)"
        ),
        metric(
            "n_samples",
            "samples recorded, 30 a second",
            "(SELECT coalesce(sum(n_rows), 0) FROM telemetry WHERE run_id = runs.id)",
        ),
    ),
    # a run that was interrupted, as in a restored backup, is older than the same run with its end
    precedence=("{side}.reason IS NOT 'interrupted'", "coalesce({side}.duration_s, 0)"),
)
EVENTS = ReplicatedTable(
    "events",
    "What happened in a run, by seq; tick / 30 is the time in s; data holds the other fields.",
    (
        parent("run_id", "runs", "its run"),
        Column("seq", COUNT, "place among the events and samples of the run"),
        Column("tick", COUNT, "when it happened, in steps of 1/30 s"),
        Column("type", TEXT, "the type of event", rules.identifier, UNCHANGED),
        Column("data", JSON, "the other fields of the event"),
    ),
    key=("run_id", "seq"),
    condition=ENDED,
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
    condition=ENDED,
    parquet=False,
)
TRUTHS = ReplicatedTable(
    "truths",
    "Where a real robot truly was in a run, by one source of truth; a run has a row for each source.",
    (
        Column("id", KEY, "key, made of run and source"),
        parent("run_id", "runs", "the run"),
        Column(
            "source",
            TEXT,
            "`tape` (a tape measure), `camera` (above the floor) or `localisation` (the robot's own)",
            rules.one_of(*TRUTH_SOURCES),
            UNCHANGED,
        ),
        Column(
            "poses",
            JSON,
            "a list of [tick, x, y, heading, one sigma of the position, one sigma of the heading] in the frame of the"
            " start (x ahead, y to the left), in m and rad; tick in steps of 1/30 s, null for where the robot was after"
            " the run; empty where somebody took the measurement back",
            rules.poses,
            UNCHANGED,
        ),
        Column("measured_at", TIME, "when it was recorded"),
        *REVISED,
    ),
    condition=ENDED,
    counts_empty=False,
)
