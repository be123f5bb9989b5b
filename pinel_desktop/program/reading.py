"""Reads a document: the program, or all its faults. Never raises because of a document's content."""

import contextlib
import gc
import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from pinel_desktop.program.checks import SemanticCheck, check_semantics
from pinel_desktop.program.duplicates import decoded, duplicate_keys, max_keys
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES, MAX_NESTING
from pinel_desktop.program.model import Program, documents
from pinel_desktop.program.pointers import Path, PathFault, has_path, in_document_order, pointer
from pinel_desktop.program.shape import check_shape
from pinel_desktop.program.translation import fault_from_error, placed_fault, relevant_errors


@dataclass(frozen=True, slots=True)
class ParseResult:
    """Result of reading a document.

    Attributes:
        program: the typed program; None if there are faults.
        faults: all faults, in the order of the document.
        warnings: ignored parts, such as unknown keys in a bare list of the original PINEL, and parts that are
            hardly intended, such as a comparison of the floor's colour with an impossible text. Empty if the
            program has faults.
    """

    program: Program | None
    faults: tuple[Fault, ...] = ()
    warnings: tuple[Fault, ...] = ()

    @property
    def document(self) -> dict[str, Any] | None:
        """The normal form as JSON data; None if there are faults."""
        if self.program is None:
            return None
        normal: dict[str, Any] = documents().dump_python(
            self.program, mode="json", by_alias=True, exclude_none=True
        )
        return normal


def read_document(source: str | bytes | dict[str, Any] | list[Any]) -> ParseResult:
    """Reads a `pinel_ir` document or a bare list of commands, given as JSON text or as parsed data."""
    with _garbage_collection_off():
        return _read(source)


@contextlib.contextmanager
def _garbage_collection_off() -> Iterator[None]:
    """Disables garbage collection, which would find nothing and double the time for reading 20,000 commands."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        # the result lives long, so it skips the young generations
        gc.freeze()
        gc.unfreeze()
        if was_on:
            gc.enable()


def _read(source: str | bytes | dict[str, Any] | list[Any]) -> ParseResult:
    if not isinstance(source, str | bytes):
        return _read_parsed(source)
    parsed = _parse(source)
    if isinstance(parsed, Fault):
        return ParseResult(None, (parsed,))
    text, document = parsed
    if isinstance(document, dict):
        # fast path for valid documents, which need no check of their shape
        semantics, program, _ = _check(document)
        is_good = program is not None and not semantics.faults and not semantics.is_large
        if is_good and (semantics.n_keys == max_keys(text) or not duplicate_keys(text)):
            return ParseResult(program, warnings=_warnings(document, semantics, bare=False))
    faults = check_shape(document)
    return (
        ParseResult(None, tuple(faults)) if faults else _read_shaped(document, duplicate_keys(text))
    )


def _read_parsed(parsed: dict[str, Any] | list[Any]) -> ParseResult:
    faults = check_shape(parsed)
    if faults:
        return ParseResult(None, tuple(faults))
    size = _size(parsed)
    if size > MAX_BYTES:
        return ParseResult(None, (_too_large(size),))
    return _read_shaped(parsed, [])


def _read_shaped(parsed: Any, duplicates: list[PathFault]) -> ParseResult:
    """Reads parsed data of limited size and depth; `duplicates` are findings for duplicate keys."""
    if isinstance(parsed, list):
        return _read_bare_list(parsed, duplicates)
    return _validate(parsed, duplicates, bare=False)


def _size(document: Any) -> int:
    """Size of parsed data as JSON, in bytes."""
    text = json.dumps(document, ensure_ascii=False, separators=(",", ":"))
    return len(text.encode("utf-8", "surrogatepass"))


def _too_large(size: int) -> Fault:
    return Fault("document_too_large", params={"value": size, "max": MAX_BYTES})


def _parse(source: str | bytes) -> tuple[str, Any] | Fault:
    if len(source) > MAX_BYTES:
        return _too_large(len(source))
    try:
        text = decoded(source)
        return text, json.loads(text)
    except RecursionError:
        return Fault("nesting_too_deep", params={"max": MAX_NESTING})
    except json.JSONDecodeError as error:
        return Fault("json_syntax", params={"line": error.lineno, "column": error.colno})
    except ValueError:  # invalid UTF-8, or a number with thousands of digits
        return Fault("json_syntax", params={"line": 1, "column": 1})


def _read_bare_list(commands: list[Any], duplicates: list[PathFault]) -> ParseResult:
    """The original's format: unknown keys, such as its `status`, are ignored with a warning."""
    document = {"pinel_ir": 1, "name": "", "commands": commands}
    duplicates = [(code, ("commands", *path), params) for code, path, params in duplicates]
    reading = _validate(document, duplicates, bare=True)
    unknown = [fault for fault in reading.faults if fault.code == "unknown_key"]
    if not unknown:
        return reading
    keys = {fault.pointer for fault in unknown}
    cleaned = {**document, "commands": _without_keys(commands, keys, "")}
    reading = _validate(
        cleaned, [one for one in duplicates if has_path(cleaned, one[1])], bare=True
    )
    return ParseResult(reading.program, reading.faults, (*unknown, *reading.warnings))


def _without_keys(value: Any, pointers: set[str], here: str) -> Any:
    if isinstance(value, list):
        return [_without_keys(item, pointers, f"{here}/{i}") for i, item in enumerate(value)]
    if isinstance(value, dict):
        places = ((key, f"{here}/{pointer([key])[1:]}") for key in value)
        retained = {key: place for key, place in places if place not in pointers}
        return {key: _without_keys(value[key], pointers, place) for key, place in retained.items()}
    return value


def _check(document: dict[str, Any]) -> tuple[SemanticCheck, Program | None, list[ErrorDetails]]:
    semantics = check_semantics(document)
    try:
        return semantics, documents().validate_python(document), []
    except ValidationError as error:
        return semantics, None, error.errors(include_url=False)


def _validate(document: dict[str, Any], duplicates: list[PathFault], *, bare: bool) -> ParseResult:
    semantics, program, errors = _check(document)
    findings = [*duplicates, *semantics.faults]
    if program is not None and not findings:
        return ParseResult(program, warnings=_warnings(document, semantics, bare=bare))
    return ParseResult(None, tuple(_faults(document, errors, findings, bare=bare)))


def _warnings(document: Any, semantics: SemanticCheck, *, bare: bool) -> tuple[Fault, ...]:
    """Warnings in the order of the document."""
    if not semantics.warnings:
        return ()  # the usual case
    placed = {path: (code, params) for code, path, params in semantics.warnings}
    return tuple(
        placed_fault(document, path, *placed[path], bare=bare)
        for path in in_document_order(document, placed)
    )


def _faults(
    document: Any, errors: list[ErrorDetails], findings: list[PathFault], *, bare: bool
) -> list[Fault]:
    """Faults in the order of the document, without repetitions."""
    placed: dict[Path, dict[Fault, None]] = {}
    for path, error in relevant_errors(document, errors):
        fault = fault_from_error(document, path, error, bare=bare)
        placed.setdefault(path, {})[fault] = None
    for code, path, params in findings:
        fault = placed_fault(document, path, code, params, bare=bare)
        placed.setdefault(path, {})[fault] = None
    return [fault for path in in_document_order(document, placed) for fault in placed[path]]
