"""Files on removable drives and in the shared folder. In kiosk mode the page offers these in place of file dialogs."""

from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.web.api import OCTETS, Resource, responses
from pinel_desktop.web.api.exchange import UploadedFile
from pinel_desktop.web.models.kiosk import (
    ChosenDriveFile,
    Drive,
    DriveFile,
    DriveList,
    FileType,
    NewDriveFile,
    SavedDriveFile,
)
from pinel_desktop.web.responses import json_response, json_safe
from pinel_desktop.web.services import services
from storage.exchange.backup_share import SHARED_FOLDER
from storage.file.atomic_files import atomic_create

if TYPE_CHECKING:  # imported when a file is read or written, not at the app's start
    from pinel_desktop.school.removable_drives import ExchangeFile, Folder

api = Resource("drives", "Files on drives, in kiosk mode.", __name__)

_CHUNK_BYTES = 2**20


@api.get("/drives", responses=responses(DriveList, "kiosk_not_active"))
def list_drives(query: FileType) -> Response:
    """Removable drives and the shared folder, each with its files of one type, newest first."""
    return json_response(DriveList(drives=[_drive(one) for one in _folders(query.suffix)]))


@api.get(
    "/drives/file",
    responses=responses(OCTETS, "kiosk_not_active", "drive_file_missing", "file_unreadable"),
)
def get_drive_file(query: ChosenDriveFile) -> Response:
    """A file that `GET /drives` lists; no other file of the PC can be read."""
    path = Path(query.path)
    if not any(path == file.path for one in _folders(query.suffix) for file in one.files):
        raise PinelError("drive_file_missing", path=query.path)
    try:
        octets = path.read_bytes()
    except OSError as error:
        raise PinelError("file_unreadable", path=query.path) from error
    return Response(octets, mimetype="application/octet-stream")


@api.post(
    "/drives/file",
    responses=responses(
        SavedDriveFile, "kiosk_not_active", "folder_missing", "body_too_large", "export_failed"
    ),
)
def write_drive_file(query: NewDriveFile, raw: UploadedFile) -> Response:
    """Writes a new file on a drive that `GET /drives` lists. The body is the file."""
    folder = next((one for one in _folders(".pinel") if str(one.path) == query.drive), None)
    if folder is None or not folder.is_reachable:
        raise PinelError("folder_missing", path=query.drive)
    target = folder.path / query.name
    try:
        with atomic_create(target) as file, file.part.open("wb") as part:
            while chunk := raw.stream.read(_CHUNK_BYTES):
                part.write(chunk)
    except OSError as error:
        raise PinelError("export_failed", path=str(target)) from error
    return json_response(
        SavedDriveFile(name=file.final.name, drive=folder.name, is_removable=folder.is_removable)
    )


def _folders(suffix: str) -> "list[Folder]":
    """Raises PinelError `kiosk_not_active`: elsewhere, the page has the system's file dialogs."""
    from pinel_desktop.school.removable_drives import folders  # noqa: PLC0415 - see above

    if not services().is_kiosk:
        raise PinelError("kiosk_not_active")
    shared = services().store.settings.get(SHARED_FOLDER)
    return folders(suffix, [Path(shared)] if shared else [])


def _drive(folder: "Folder") -> Drive:
    return Drive(
        path=json_safe(str(folder.path)),
        name=json_safe(folder.name),
        is_removable=folder.is_removable,
        is_writable=folder.is_writable,
        files=[_file(file) for file in folder.files],
    )


def _file(file: "ExchangeFile") -> DriveFile:
    return DriveFile(
        path=json_safe(str(file.path)),
        name=json_safe(file.path.name),
        size_bytes=file.size_bytes,
        modified_at=datetime.fromtimestamp(file.modified_s, UTC).isoformat(),
    )
