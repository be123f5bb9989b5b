"""Writes `files/` by using the program, and records how the program reads them.

It ran at commit a15e9a7d (files/README.md) and documents the files. Do not run it at a later commit: the files would no
longer be of an earlier release. From the root: `python -m tests.compatibility.write_files`.
"""

import gzip
import json
import shutil
from pathlib import Path
from typing import Any

from storage import open_store
from tests.compatibility import archived_files as kept
from tests.compatibility.archived_files import DATABASE, FILES, SAMPLES, pinel
from tests.compatibility.school_day import FIRST, PROGRAM_FILE, SCHOOL, SECOND, play


def export(database: Path, name: str, *options: str) -> None:
    """Exports a bundle beside the database and packs it."""
    target = SCHOOL / f"{name}.pinel"
    status, _ = pinel("--db", database, "export", target, *options)
    assert status == 0
    pack(f"bundles/{target.name}", target.read_bytes())


def pack(name: str, octets: bytes) -> None:
    target = FILES / f"{name}.gz"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(gzip.compress(octets, 9, mtime=0))


def pack_all() -> None:
    """The first PC's files after the power cut, the backup, and bundles of both PCs."""
    for file in (FIRST / DATABASE, FIRST / f"{DATABASE}-wal", *(FIRST / "backups").glob("*.db")):
        pack(f"database/{file.relative_to(FIRST)}", file.read_bytes())
    pack("bundles/program.pinel", PROGRAM_FILE.read_bytes())
    database = kept.unpack("database", SCHOOL / "copy") / DATABASE
    export(database, "all")
    export(database, "class", "--class", "6º A")
    export(database, "anonymous", "--anonymous")
    export(SECOND / DATABASE, "second_pc")


def main() -> None:
    for folder in ("database", "bundles"):
        shutil.rmtree(FILES / folder, ignore_errors=True)
    play()
    pack_all()
    note("summary", summary(SCHOOL / "records"))
    note("results", results())


def note(name: str, record: Any) -> None:
    text = json.dumps(record, ensure_ascii=False, indent=1)
    (FILES / f"{name}.json").write_text(f"{text}\n", "utf-8")


def summary(folder: Path) -> dict[str, Any]:
    """Content of the files as the program reads it."""
    home = kept.unpack("database", folder / "database")
    with open_store(home / DATABASE) as store:
        found = store.exchange.content_hash()
    with kept.opened(home) as browser:
        report = kept.reported(browser)
    for run in report["runs"]:
        if run["reason"] == "interrupted":
            del run["ended_at"]  # for the last run this is the time of the restart
    verdicts = {run["id"]: kept.verdict(home / DATABASE, run["id"]) for run in report["runs"]}
    return {
        "platform": kept.platform_of_figures(),
        "database": {"content_hash": found, **report},
        "verdicts": verdicts,
        "backup": kept.backup_restored(folder / "backup"),
        "merged": kept.all_merged(folder / "merged"),
        "program": kept.program_brought(folder / "program"),
    }


def results() -> dict[str, Any]:
    """What `pinel run` prints of each program."""
    answers = [
        "--gestures",
        "B,",
        "--answers",
        "Ana,11",
        "--world",
        "furnished_room",
        "--seed",
        "5",
    ]
    options = {
        "every_command": answers,
        "conversation": ["--answers", "Ana,3"],
        "stairs": ["--preset", "realistic", "--feedback", "odometry"],
        "original": ["--gestures", "C"],
    }
    for file in sorted(SAMPLES.glob("*.values.json")):
        values = json.loads(file.read_text("utf-8"))
        named = ["--world", values.get("world", "empty_room")]
        signs = ["--gestures", ",".join(values["gestures"])] if "gestures" in values else []
        options[file.name.removesuffix(".values.json")] = named + signs
    return {
        name: {"options": arguments, "result": kept.result(kept.sources(name)[0], arguments)}
        for name, arguments in options.items()
    }


if __name__ == "__main__":
    main()
