"""Declarations of the tables whose rows stay on one PC."""

from storage.tables import rules
from storage.tables.columns import (
    JSON,
    KEY,
    TEXT,
    TIME,
    UNCHANGED,
    Column,
    Table,
)

LOCAL = (
    Table(
        "settings",
        "What was chosen, as JSON.",
        (
            Column("key", TEXT, "name of the setting", rules.short, UNCHANGED),
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
            Column("computer_name", TEXT, "its name then", rules.name, UNCHANGED),
            Column("file", TEXT, "name of the file", rules.short, UNCHANGED),
            Column("checksum", TEXT, "content hash of the file", rules.sha256, UNCHANGED),
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
            Column("path", TEXT, "where the file was written", rules.short, UNCHANGED),
            Column("made_at", TIME, "when it was written"),
            Column("content", JSON, "its checksum, what it is of, and how many runs are in it"),
        ),
    ),
    Table(
        "signatures",
        "Of releases before 0.3, which signed bundles; not read any more.",
        (
            Column("public_key", TEXT, "the PC's public key, in hex", rules.sha256, UNCHANGED),
            Column("signature", TEXT, "Ed25519, in hex", rules.short, UNCHANGED),
        ),
        key=("public_key",),
    ),
    Table(
        "computer_keys",
        "Of releases before 0.3, where a teacher approved keys; not read any more.",
        (
            Column("public_key", TEXT, "the PC's public key, in hex", rules.sha256, UNCHANGED),
            Column("computer_id", KEY, "the PC"),
            Column("name", TEXT, "its name then", rules.name, UNCHANGED),
            Column("seen_at", TIME, "when a bundle of this key was merged last"),
            Column("approved_at", TIME, "when the teacher approved it", optional=True),
        ),
        key=("public_key",),
    ),
    Table(
        "unconfirmed_runs",
        "Runs that came with files, whose pass does not count until this PC has repeated them.",
        (
            Column("run_id", KEY, "the run"),
            Column("public_key", TEXT, "not used any more", rules.sha256, UNCHANGED, optional=True),
            Column("marked_at", TIME, "when it came"),
            Column(
                "finding",
                TEXT,
                "`differs`, `not_passed` or `not_repeatable`; null while it waits",
                rules.short,
                UNCHANGED,
                optional=True,
            ),
        ),
        key=("run_id",),
    ),
    Table(
        "content_sums",
        "What each version and each run that has ended was when it was written, so that a damaged value is seen.",
        (
            Column(
                "table_name",
                TEXT,
                "`versions`, `runs`, or `events` and `telemetry` for all of a run",
                rules.one_of("versions", "runs", "events", "telemetry"),
                UNCHANGED,
            ),
            Column("row_id", KEY, "key of the version or the run"),
            Column("sha256", TEXT, "SHA-256 of its values, in hex", rules.sha256, UNCHANGED),
            Column("damaged_at", TIME, "when it was found to be another", optional=True),
        ),
        key=("table_name", "row_id"),
    ),
)
