"""Kiosk mode, and the files on drives that replace its file dialogs."""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.web.models import RequestModel, ResponseModel, Time

_Path = Annotated[str, Field(max_length=4000)]
# file types that the page reads or writes
_Suffix = Literal[".pinel", ".json", ".onnx"]
_FILE_NAME = (
    r"^[^/\\:*?\"<>|\x00-\x1f.][^/\\:*?\"<>|\x00-\x1f]{0,119}\.(pinel|json|py|csv|png|gif|html)$"
)


class KioskState(ResponseModel):
    """Kiosk mode of this PC."""

    is_active: Annotated[bool, Field(description="the window is in kiosk mode")]
    is_chosen: Annotated[bool, Field(description="the window opens in kiosk mode")]
    is_by_command: Annotated[bool, Field(description="`pinel --kiosk`, whatever is chosen")]
    has_window: Annotated[bool, Field(description="false if a browser shows the page")]


class KioskChoice(RequestModel):
    """Whether the window opens in kiosk mode."""

    is_chosen: bool


class DriveFile(ResponseModel):
    """A file; `modified_at` is by the clock of the PC that wrote it."""

    path: str
    name: str
    size_bytes: int
    modified_at: Time


class Drive(ResponseModel):
    """A removable drive, or the school's shared folder, with its files of one type, newest first."""

    path: str
    name: str
    is_removable: bool
    is_writable: bool
    files: list[DriveFile]


class DriveList(ResponseModel):
    """Removable drives first."""

    drives: list[Drive]


class FileType(RequestModel):
    """The type of the files, as the end of their names."""

    suffix: _Suffix


class ChosenDriveFile(RequestModel):
    """A file of `GET /drives`."""

    path: _Path
    suffix: _Suffix


class NewDriveFile(RequestModel):
    """The drive of `GET /drives`, and the name of a new file on it."""

    drive: _Path
    name: Annotated[str, Field(pattern=_FILE_NAME)]


class SavedDriveFile(ResponseModel):
    """The name of the written file, which has a number if the name was taken, and the name of its drive."""

    name: str
    drive: str
    is_removable: bool
