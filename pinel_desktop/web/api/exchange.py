"""Transfer of work between PCs: removable drives, shared folders, and a program or a group as a file."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from flask import Request, Response

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe
from pinel_desktop.web.api import OCTETS, TEACHER, WRITES, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.classes import Lesson
from pinel_desktop.web.models.errors import Notice
from pinel_desktop.web.models.exchange import (
    Bundle,
    BundlesToMerge,
    FileFound,
    FileOpened,
    Folder,
    FolderList,
    ImportedProgram,
    KnownComputer,
    KnownComputerList,
    Merged,
    MergedCounts,
    MergeList,
    NameOfFile,
    NewBundle,
    PendingDeletion,
    SharedFolder,
    UnconfirmedCounts,
    UndecidedDeletion,
)
from pinel_desktop.web.responses import json_response, json_safe, notice
from pinel_desktop.web.services import services
from pinel_desktop.web.teaching import require_teacher
from storage import StoreError
from storage.exchange.backup_share import COPIES_BACKUPS, SHARED_FOLDER
from storage.file.temporary import temporary_folder
from storage.text import to_json

if TYPE_CHECKING:  # imported when a file is read or written, not at the app's start
    from pinel_desktop.school.removable_drives import ExchangeFile as FileOnDisk
    from pinel_desktop.school.removable_drives import Folder as FolderOnDisk
    from storage.exchange.bundle_writing import BundleInfo
    from storage.exchange.deleting.unresolved import UnresolvedDeletion
    from storage.exchange.merge_report import MergeReport
    from storage.exchange.scope import Scope

api = Resource("exchange", "Transfer of work between PCs.", __name__)


@api.get("/folders", responses=responses(FolderList, *TEACHER))
def list_folders() -> Response:
    """Removable drives and the shared folder, each with its bundles, newest first. For the teacher."""
    require_teacher()
    return _folders()


@api.put("/folders/shared", responses=responses(FolderList, *TEACHER, "folder_missing", *WRITES))
def choose_shared_folder(body: SharedFolder) -> Response:
    """Sets the school's shared folder, and whether copies of the backups go there. For the teacher."""
    require_teacher()
    store = services().store
    is_known = body.takes_backups is not None and body.path == store.settings.get(SHARED_FOLDER)
    # copies of backups can be switched off also while the folder is unreachable
    if body.path and not is_known:
        require_folder(body.path)
    store.settings.set(SHARED_FOLDER, body.path)
    if body.takes_backups is not None:
        store.settings.set(COPIES_BACKUPS, body.takes_backups)
    store.backup_share.update()
    return _folders()


@api.post(
    "/bundles",
    responses=responses(
        Bundle, *TEACHER, "classroom_not_found", "group_not_found", "folder_missing", *WRITES
    ),
)
def write_bundle(body: NewBundle) -> Response:
    """Writes a bundle of all work, or of one class or group, into a folder. For the teacher."""
    from pinel_desktop.activities import shipped_texts  # noqa: PLC0415 - see above
    from storage.exchange.bundle_writing import SUFFIX  # noqa: PLC0415
    from storage.exchange.scope import Scope  # noqa: PLC0415

    require_teacher()
    folder = Path(body.folder)
    require_folder(body.folder)
    parts = services()
    computer = parts.store.computers.this()
    language = parts.settings.language
    nameless = describe("file_without_names", {}, language).message
    name = nameless if body.anonymous else file_name(computer[1])
    dest = folder / f"{name}-{datetime.now().astimezone():%Y-%m-%d}{SUFFIX}"
    scope = Scope(classroom_id=body.classroom_id, group_id=body.group_id)
    info = parts.store.exchange.export(
        dest,
        app_version=parts.app_version,
        computer=computer,
        scope=scope,
        anonymous=shipped_texts() if body.anonymous else None,
    )
    return json_response(_bundle(info))


@api.post("/bundles/merge", responses=responses(MergeList, *TEACHER))
def merge_bundles(body: BundlesToMerge) -> Response:
    """Merges bundles; a refused one does not stop the others. For the teacher."""
    require_teacher()
    merged = [_merged(Path(path), body) for path in body.paths]
    for one in merged:
        if one.problem is None:
            services().opened_file.forget(Path(one.path))
    services().signs.refresh()
    services().confirm_runs()
    return json_response(
        MergeList(merged=merged, content_hash=services().store.exchange.content_hash())
    )


@api.get("/bundles/heard", responses=responses(KnownComputerList, *TEACHER))
def list_known_computers() -> Response:
    """PCs whose work was merged into this one, with times. For the teacher."""
    require_teacher()
    store = services().store
    known = [KnownComputer.of(one) for one in store.exchange.known_computers()]
    counts = UnconfirmedCounts(**store.unconfirmed.counts())
    undecided = [_undecided(one) for one in store.exchange.unresolved_deletions()]
    return json_response(
        KnownComputerList(computers=known, unconfirmed=counts, undecided=undecided)
    )


def _undecided(one: "UnresolvedDeletion") -> UndecidedDeletion:
    fields = asdict(one) | {"name": Path(one.path).name}
    del fields["computer_id"]
    return UndecidedDeletion(**{name: json_safe(value) for name, value in fields.items()})


@api.get("/programs/<id>/file", responses=responses(OCTETS, "program_not_found", *WRITES))
def get_program_file(path: IdPath) -> Response:
    """A program with its group, versions and runs as a file, to continue on another PC.

    If work had to be left out, the header `Pinel-Left-Out` is a `Notice` about it, in ASCII.
    """
    from storage.exchange.scope import Scope  # noqa: PLC0415 - see above

    return _work_file(services().store.programs.get(path.id).name, Scope(program_id=path.id))


@api.get("/groups/<id>/file", responses=responses(OCTETS, "group_not_found", *WRITES))
def get_group_file(path: IdPath) -> Response:
    """All work of a group as a file, to continue on another PC; `Pinel-Left-Out` as for a program."""
    from storage.exchange.scope import Scope  # noqa: PLC0415 - see above

    return _work_file(services().store.groups.get(path.id).name, Scope(group_id=path.id))


def _work_file(name: str, scope: "Scope") -> Response:
    from storage.exchange.bundle_writing import SUFFIX  # noqa: PLC0415 - see above

    parts = services()
    with temporary_folder() as folder:
        info = parts.store.exchange.export(
            folder / f"{file_name(name)}{SUFFIX}",
            app_version=parts.app_version,
            computer=parts.store.computers.this(),
            scope=scope,
            is_recorded=False,
        )
        octets = info.path.read_bytes()
    response = Response(octets, mimetype="application/octet-stream")
    if lacks := _left_out(info, "program_file_left_out"):
        response.headers["Pinel-Left-Out"] = to_json(lacks.model_dump())
    return response


class UploadedFile(Request):
    """A request body with a file."""

    mimetypes = ("application/octet-stream",)


@api.post(
    "/programs/file",
    responses=responses(
        ImportedProgram, "program_not_found", "body_too_large", "bundle_not_program", *WRITES
    ),
)
def read_program_file(query: NameOfFile, raw: UploadedFile) -> Response:
    """Imports a program's or a group's file of another PC; returns its newest program. The body is the file."""
    with uploaded(raw, query.name) as path:
        report, program_id = services().store.exchange.merge_program(path)
    services().signs.refresh()
    services().confirm_runs()
    # raises program_not_found if the program was deleted here for good
    program = services().store.programs.get(program_id)
    return json_response(
        ImportedProgram(
            program_id=program.id,
            group_id=program.group_id,
            classroom_id=services().store.groups.get(program.group_id).classroom_id,
            nothing_new=report.nothing_new,
        )
    )


@contextmanager
def uploaded(raw: UploadedFile, name: str) -> Iterator[Path]:
    """Writes the request's body to a temporary file, yields its path and deletes it; errors show the chosen name."""
    with temporary_folder() as folder:
        path = folder / "upload"
        with path.open("wb") as file:
            while chunk := raw.stream.read(2**20):
                file.write(chunk)
        with naming_file(path, name or path.name):
            yield path


@contextmanager
def naming_file(path: Path, name: str) -> Iterator[None]:
    """Replaces the temporary path in errors by the name of the file that the person chose."""
    try:
        yield
    except StoreError as error:
        if error.params.get("path") == str(path):
            error.params["path"] = name
        raise


def require_folder(path: str) -> None:
    """Raises PinelError `folder_missing`."""
    if not _is_folder(path):
        raise PinelError("folder_missing", path=path)


def _is_folder(path: str) -> bool:
    """True for an existing folder. False also for invalid paths: empty, too long, or with forbidden characters."""
    try:
        return bool(path) and Path(path).is_dir()
    except (OSError, ValueError):
        return False


def _folders() -> Response:
    from pinel_desktop.school.removable_drives import folders  # noqa: PLC0415 - see above
    from storage.exchange.bundle_writing import SUFFIX  # noqa: PLC0415

    settings = services().store.settings
    shared = settings.get(SHARED_FOLDER)
    found = folders(SUFFIX, [Path(shared)] if shared else [])
    return json_response(
        FolderList(
            folders=[_folder(one) for one in found],
            opened=_opened(services().opened_file.path),
            shared=json_safe(shared or ""),
            takes_backups=bool(settings.get(COPIES_BACKUPS)),
        )
    )


def _opened(path: Path | None) -> FileOpened | None:
    from pinel_desktop.school.opened_file import examined  # noqa: PLC0415 - see above

    if path is None:
        return None
    name = json_safe(path.name)
    try:
        with naming_file(path, path.name):
            return FileOpened(name=name, file=_file(examined(path)), problem=None)
    except (PinelError, StoreError) as error:
        problem = notice(error.code, error.params, services().settings.language)
        return FileOpened(name=name, file=None, problem=problem)


def _folder(folder: "FolderOnDisk") -> Folder:
    return Folder(
        path=json_safe(str(folder.path)),
        name=json_safe(folder.name),
        is_removable=folder.is_removable,
        is_reachable=folder.is_reachable,
        is_writable=folder.is_writable,
        free_bytes=folder.free_bytes,
        files=[_file(file) for file in folder.files],
    )


def _file(file: "FileOnDisk") -> FileFound:
    from storage.exchange.bundle_reading import declaration_of, prepares_lesson  # noqa: PLC0415 - see above

    anonymous, computer_id = declaration_of(file.path, file.size_bytes, file.modified_s)
    return FileFound(
        path=json_safe(str(file.path)),
        name=json_safe(file.path.name),
        size_bytes=file.size_bytes,
        anonymous=anonymous,
        own=services().store.computers.is_this(computer_id),
        lesson=prepares_lesson(file.path),
        modified_at=datetime.fromtimestamp(file.modified_s, UTC).isoformat(),
    )


def file_name(name: str) -> str:
    """Converts a name to a file name that is valid on every file system."""
    return re.sub(r"[^\w -]", "", name).strip()[:60] or "PINEL"


def _bundle(info: "BundleInfo") -> Bundle:
    return Bundle(
        path=str(info.path),
        name=info.path.name,
        exported_at=info.exported_at,
        n_groups=info.counts.get("groups", 0),
        n_programs=info.counts.get("programs", 0),
        n_runs=info.counts.get("runs", 0),
        left_out=_left_out(info, "export_left_out"),
    )


def _left_out(info: "BundleInfo", code: str) -> Notice | None:
    """Returns a message about the work that a file lacks; None if it is complete."""
    if not info.left_out:
        return None
    return notice(code, info.left_out_params, services().settings.language)


def _merged(path: Path, body: BundlesToMerge) -> Merged:
    parts = services()
    try:
        with naming_file(path, path.name):
            report = parts.store.exchange.merge(
                path, delete=body.delete, retained=body.kept, retain_newer=body.keep_newer
            )
            return _report(path, report)
    except StoreError as error:
        problem = notice(error.code, error.params, parts.settings.language)
        return Merged(path=str(path), name=path.name, added=_counts({}), problem=problem)


def _report(path: Path, report: "MergeReport") -> Merged:
    lessons = services().store.lessons
    return Merged(
        path=str(path),
        name=path.name,
        computer=report.info.computer_name,
        exported_at=report.info.exported_at,
        added=_counts(report.added),
        anonymous=report.info.anonymous,
        nothing_new=not (report.added or report.changed or report.removed or report.retained),
        held_back=_counts(report.skipped) if report.skipped else None,
        removed=_counts(report.removed) if report.removed else None,
        kept=[one.name for one in report.retained],
        would_delete=_pending_deletion(report),
        left_in=[json_safe(path) for path in report.left_in],
        n_unconfirmed=report.n_unconfirmed,
        lesson=Lesson.of(lessons.get(report.lesson_id)) if report.lesson_id else None,
    )


def _pending_deletion(report: "MergeReport") -> PendingDeletion | None:
    pending = report.would_delete
    return None if pending is None else PendingDeletion.of(pending)


def _counts(rows: dict[str, int]) -> MergedCounts:
    return MergedCounts(**{name: rows.get(name, 0) for name in MergedCounts.model_fields})
