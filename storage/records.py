"""Rows as the store hands them out. Times are ISO 8601 text in UTC, ids UUIDv7 text."""

from dataclasses import dataclass, field
from typing import Any

Json = dict[str, Any]
NO_FAULTS: tuple["FaultRow", ...] = ()


@dataclass(frozen=True, slots=True)
class GroupRow:
    """Pupils who work together."""

    id: str
    name: str
    color: str
    created_at: str
    n_programs: int = 0
    n_runs: int = 0


@dataclass(frozen=True, slots=True)
class ProgramRow:
    """Saved blocks of a group."""

    id: str
    name: str
    group_id: str
    created_at: str
    updated_at: str
    n_versions: int = 0
    n_runs: int = 0


@dataclass(frozen=True, slots=True)
class FaultRow:
    """One thing wrong with a document, without its words."""

    code: str
    pointer: str
    block: str | None
    params: Json


@dataclass(frozen=True, slots=True)
class VersionRow:
    """One state of a program; `document` is None while it has faults, `world` where none was made for it."""

    id: str
    program_id: str
    created_at: str
    workspace: Json
    document: Json | None
    faults: tuple[FaultRow, ...]
    world: Json | None = None


@dataclass(frozen=True, slots=True)
class RunStart:
    """What is known when a run begins. Give `version_id`, or `document` for a run without a version."""

    link: str
    world: str
    world_document: Json
    seed: int
    app_version: str
    version_id: str | None = None
    document: Json | None = None
    parameters: Json = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class RunRow:
    """One execution; figures are None until it has ended."""

    id: str
    group_id: str | None
    program_id: str | None
    program_name: str | None
    version_id: str | None
    document: Json | None
    link: str
    world: str
    world_document: Json
    seed: int
    parameters: Json
    app_version: str
    state: str
    reason: str | None
    params: Json
    block: str | None
    started_at: str
    ended_at: str | None
    duration_s: float | None
    n_executed: int | None
    path_length_m: float | None
    closing_error_m: float | None
    summary: Json
    telemetry_sha256: str | None
    path: list[list[float]]
