"""Bundles: files that transfer work between PCs."""

from typing import Annotated, Literal

from pydantic import Field

from pinel_desktop.web.models import Id, RequestModel, ResponseModel, Time
from pinel_desktop.web.models.classes import Lesson
from pinel_desktop.web.models.errors import Notice

_Path = Annotated[str, Field(max_length=4000)]


class FileFound(ResponseModel):
    """A bundle in a folder; `modified_at` is by the clock of the PC that wrote it.

    Merging an `anonymous` bundle adds its groups again as "Grupo 1" and so on, even if the store has them.
    """

    path: str
    name: str
    size_bytes: int
    anonymous: bool
    own: Annotated[bool, Field(description="written on this PC, so that merging it brings nothing")]
    lesson: Annotated[bool, Field(description="it prepares a PC for a lesson")]
    modified_at: Time


class Folder(ResponseModel):
    """A removable drive, or the school's shared folder; `free_bytes` is null if unknown.

    The shared folder is listed even if it cannot be read; `is_reachable` is false then.
    """

    path: str
    name: str
    is_removable: bool
    is_reachable: bool
    is_writable: bool
    free_bytes: int | None
    files: list[FileFound]


class FileOpened(ResponseModel):
    """The file with which a person has opened the app: what it is, or the problem with it."""

    name: str
    file: FileFound | None
    problem: Notice | None


class FileToOpen(RequestModel):
    """A file of this PC."""

    path: _Path


class FolderList(ResponseModel):
    """Removable drives first; `shared` is the path of the shared folder, "" for none.

    If `takes_backups` is true, this PC also copies its backups to the shared folder. `opened` is null if the app was
    opened without a file, or if that file has been merged.
    """

    folders: list[Folder]
    opened: FileOpened | None
    shared: str
    takes_backups: bool


class SharedFolder(RequestModel):
    """A folder of this PC or of the network; "" for none. If `takes_backups` is omitted, it stays unchanged."""

    path: _Path
    takes_backups: Annotated[
        bool | None, Field(description="copies of this PC's backups go there too")
    ] = None


class NewBundle(RequestModel):
    """The target folder, and the content: all work, or the work of one class or group."""

    folder: _Path
    classroom_id: Id | None = None
    group_id: Id | None = None
    anonymous: Annotated[bool, Field(description="without names and texts")] = False


class Bundle(ResponseModel):
    """A written bundle; `left_out` is a message about work of this PC that other PCs would refuse."""

    path: str
    name: str
    exported_at: Time
    n_groups: int
    n_programs: int
    n_runs: int
    left_out: Notice | None


class BundlesToMerge(RequestModel):
    """Files to merge, in this order."""

    paths: Annotated[list[_Path], Field(min_length=1, max_length=500)]
    delete: Annotated[bool, Field(description="also apply deletions of the other PC")] = False
    kept: list[Id] = Field(
        default=[], max_length=5000, description="groups and programs that stay nevertheless"
    )
    keep_newer: Annotated[bool, Field(description="keep what was moved or is newer too")] = True


class MergedCounts(ResponseModel):
    """Numbers of rows."""

    groups: int
    programs: int
    versions: int
    runs: int


class PendingWork(ResponseModel):
    """A group that would be deleted, or a program of a group that stays, with the work unknown to the deleting PC."""

    kind: Literal["group", "program"]
    id: Id
    name: str
    place: Annotated[str, Field(description='class of the group now, group of the program, or ""')]
    is_moved: Annotated[bool, Field(description="in another class than where it was deleted")]
    is_newer: Annotated[bool, Field(description="moved, or with work that was unknown there")]
    n_programs: int
    n_runs: int
    n_new_programs: int
    n_new_edits: int
    n_new_runs: int


class PendingDeletion(ResponseModel):
    """Work deleted for good on another PC that this PC still has, until the teacher confirms the deletion."""

    groups: int
    programs: int
    runs: int
    names: Annotated[list[str], Field(description="of classes and groups, not more than a few")]
    work: Annotated[list[PendingWork], Field(description="what can be kept")]


class Merged(ResponseModel):
    """The result of merging one file: the rows `added`, or the `problem` for which the file was refused.

    `held_back` counts rows not added because they were deleted for good on this PC. `removed` counts rows that this
    merge deleted. Both are null without such rows; all numbers are 0 if they are rows of other kinds only.

    `would_delete` is work that another PC deleted; it stays until the file is merged with `delete`. After that the
    files in `left_in` may still contain it: bundles written on this PC, and backups that could not be rewritten.

    `n_unconfirmed` counts runs of the file whose pass does not count before this PC has repeated them.
    """

    path: str
    name: str
    computer: str | None = None
    exported_at: Time | None = None
    added: MergedCounts
    anonymous: bool = False
    nothing_new: bool = True
    held_back: MergedCounts | None = None
    removed: MergedCounts | None = None
    kept: list[str] = Field(default=[], description="names of what was kept")
    would_delete: PendingDeletion | None = None
    left_in: list[str] = Field(default=[])
    n_unconfirmed: int = 0
    lesson: Annotated[
        Lesson | None, Field(description="the newest with work in the file, as it is now")
    ] = None
    problem: Notice | None = None


class MergeList(ResponseModel):
    """Results in the order of the files; `content_hash` is equal on all PCs with the same work."""

    merged: list[Merged]
    content_hash: str


class NameOfFile(RequestModel):
    """The name of the chosen file, for messages."""

    name: Annotated[str, Field(max_length=1000)] = ""


class ImportedProgram(ResponseModel):
    """A program imported from a file, with its group and class."""

    program_id: Id
    group_id: Id
    classroom_id: Id | None
    nothing_new: bool


class KnownComputer(ResponseModel):
    """A PC whose work was merged; `exported_at` and `merged_at` belong to its latest bundle."""

    computer_id: Id
    name: str
    exported_at: Time
    merged_at: Time
    n_runs: int


class UnconfirmedCounts(ResponseModel):
    """Merged runs whose pass does not count, by the finding of their re-verification."""

    waiting: int = 0
    differs: int = 0
    not_passed: int = 0
    not_repeatable: int = 0


class UndecidedDeletion(ResponseModel):
    """Work deleted for good on another PC, about which this PC has not decided yet; merging `path` asks again."""

    computer: str
    path: str
    name: Annotated[str, Field(description="of the file")]
    exported_at: Time
    groups: int
    programs: int
    runs: int


class KnownComputerList(ResponseModel):
    """PCs, the most recently merged first."""

    computers: list[KnownComputer]
    unconfirmed: UnconfirmedCounts
    undecided: list[UndecidedDeletion]


class WrittenFile(ResponseModel):
    """A bundle written on this PC."""

    path: str
    made_at: Time


class Removed(ResponseModel):
    """Numbers of rows deleted for good from the database and its backups.

    Some files may still contain them: `backups` that could not be rewritten, and bundles written on this PC (`files`).
    """

    n_groups: int
    n_programs: int
    n_runs: int
    backups: list[str]
    files: list[WrittenFile]
