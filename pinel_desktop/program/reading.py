"""Reading a document: all of its faults, or the program. Never raises for what a document contains."""

import contextlib
import gc
import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from pinel_desktop.program.checks import Meaning, check_meaning
from pinel_desktop.program.duplicates import decoded, duplicate_keys, most_keys
from pinel_desktop.program.faults import Fault
from pinel_desktop.program.limits import MAX_BYTES, MAX_NESTING
from pinel_desktop.program.model import Program, documents
from pinel_desktop.program.pointers import Finding, Path, has_path, in_document_order, pointer
from pinel_desktop.program.shape import check_shape
from pinel_desktop.program.translation import fault_from_error, placed_fault, relevant_errors


@dataclass(frozen=True, slots=True)
class Reading:
    """Outcome of reading a document.

    Attributes:
        program: the typed program, None with faults.
        faults: everything that is wrong, in the order of the document.
        warnings: what was passed over, such as unknown keys in a bare list of the original.
    """

    program: Program | None
    faults: tuple[Fault, ...] = ()
    warnings: tuple[Fault, ...] = ()

    @property
    def document(self) -> dict[str, Any] | None:
        """The normal form as plain JSON data, None with faults."""
        if self.program is None:
            return None
        normal: dict[str, Any] = documents().dump_python(
            self.program, mode="json", by_alias=True, exclude_none=True
        )
        return normal


def read_document(source: str | bytes | dict[str, Any] | list[Any]) -> Reading:
    """Reads a document given as JSON text or as parsed data: a `pinel_ir` document or a bare list of commands."""
    with _no_collecting():
        return _read(source)


@contextlib.contextmanager
def _no_collecting() -> Iterator[None]:
    """Nothing that is read is garbage yet, and looking for it among 20,000 commands takes as long as reading."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        # what was read will be kept: straight to the oldest generation, without being looked through on the way
        gc.freeze()
        gc.unfreeze()
        if was_on:
            gc.enable()


def _read(source: str | bytes | dict[str, Any] | list[Any]) -> Reading:
    if not isinstance(source, str | bytes):
        return _read_parsed(source)
    parsed = _parse(source)
    if isinstance(parsed, Fault):
        return Reading(None, (parsed,))
    text, document = parsed
    if isinstance(document, dict):
        # most documents are good, and then nothing needs to be known of their shape
        meaning, program, _ = _looked_at(document)
        is_good = program is not None and not meaning.findings and not meaning.is_large
        if is_good and (meaning.n_keys == most_keys(text) or not duplicate_keys(text)):
            return Reading(program)
    faults = check_shape(document)
    return Reading(None, tuple(faults)) if faults else _read_shaped(document, duplicate_keys(text))


def _read_parsed(parsed: dict[str, Any] | list[Any]) -> Reading:
    faults = check_shape(parsed)
    if faults:
        return Reading(None, tuple(faults))
    size = _size(parsed)
    if size > MAX_BYTES:
        return Reading(None, (_too_large(size),))
    return _read_shaped(parsed, [])


def _read_shaped(parsed: Any, doubled: list[Finding]) -> Reading:
    """Reads parsed data of a size and depth that can be looked through; `doubled` are the keys that are there twice."""
    if isinstance(parsed, list):
        return _read_bare_list(parsed, doubled)
    return _validate(parsed, doubled, bare=False)


def _size(document: Any) -> int:
    """Length in bytes of parsed data as JSON."""
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
    except ValueError:  # not UTF-8, or a number with thousands of digits
        return Fault("json_syntax", params={"line": 1, "column": 1})


def _read_bare_list(commands: list[Any], doubled: list[Finding]) -> Reading:
    """The original's format: unknown keys, such as its `status`, are passed over with a warning."""
    document = {"pinel_ir": 1, "name": "", "commands": commands}
    doubled = [(code, ("commands", *path), params) for code, path, params in doubled]
    reading = _validate(document, doubled, bare=True)
    unknown = [fault for fault in reading.faults if fault.code == "unknown_key"]
    if not unknown:
        return reading
    keys = {fault.pointer for fault in unknown}
    cleaned = {**document, "commands": _without_keys(commands, keys, "")}
    reading = _validate(cleaned, [one for one in doubled if has_path(cleaned, one[1])], bare=True)
    return Reading(reading.program, reading.faults, tuple(unknown))


def _without_keys(value: Any, pointers: set[str], here: str) -> Any:
    if isinstance(value, list):
        return [_without_keys(item, pointers, f"{here}/{i}") for i, item in enumerate(value)]
    if isinstance(value, dict):
        places = ((key, f"{here}/{pointer([key])[1:]}") for key in value)
        kept = {key: place for key, place in places if place not in pointers}
        return {key: _without_keys(value[key], pointers, place) for key, place in kept.items()}
    return value


def _looked_at(document: dict[str, Any]) -> tuple[Meaning, Program | None, list[ErrorDetails]]:
    meaning = check_meaning(document)
    try:
        return meaning, documents().validate_python(document), []
    except ValidationError as error:
        return meaning, None, error.errors(include_url=False)


def _validate(document: dict[str, Any], doubled: list[Finding], *, bare: bool) -> Reading:
    meaning, program, errors = _looked_at(document)
    findings = [*doubled, *meaning.findings]
    if program is not None and not findings:
        return Reading(program)
    return Reading(None, tuple(_faults(document, errors, findings, bare=bare)))


def _faults(
    document: Any, errors: list[ErrorDetails], findings: list[Finding], *, bare: bool
) -> list[Fault]:
    """Faults in the order of the document, each once."""
    placed: dict[Path, dict[Fault, None]] = {}
    for path, error in relevant_errors(document, errors):
        fault = fault_from_error(document, path, error, bare=bare)
        placed.setdefault(path, {})[fault] = None
    for code, path, params in findings:
        fault = placed_fault(document, path, code, params, bare=bare)
        placed.setdefault(path, {})[fault] = None
    return [fault for path in in_document_order(document, placed) for fault in placed[path]]
