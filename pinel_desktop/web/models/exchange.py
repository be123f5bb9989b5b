"""Bundles: files that carry work from PC to PC."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import Body, Id, Shape, Time
from pinel_desktop.web.models.errors import Notice

_Path = Annotated[str, Field(max_length=4000)]


class FileFound(Shape):
    """A bundle that lies in a folder; `modified_at` by the clock of the PC that wrote it.

    From one that is `anonymous` groups come a second time where they are already, as "Grupo 1" and so on.
    """

    path: str
    name: str
    size_bytes: int
    anonymous: bool
    modified_at: Time


class Folder(Shape):
    """A stick that is plugged in, or the school's shared folder; `free_bytes` null where nobody can tell.

    The shared folder is told while it does not answer too, then with `is_reachable` false.
    """

    path: str
    name: str
    is_stick: bool
    is_reachable: bool
    is_writable: bool
    free_bytes: int | None
    files: list[FileFound]


class FolderList(Shape):
    """Sticks first; `shared` is the path of the shared folder, "" for none."""

    folders: list[Folder]
    shared: str


class SharedFolder(Body):
    """A folder of this PC or of the network; "" for none."""

    path: _Path


class NewBundle(Body):
    """Where to, and of what: all, or one class or group."""

    folder: _Path
    classroom_id: Id | None = None
    group_id: Id | None = None
    anonymous: Annotated[bool, Field(description="without names and texts")] = False


class Bundle(Shape):
    """A bundle that was written; `left_out` says how much of this PC's work other PCs would refuse."""

    path: str
    name: str
    exported_at: Time
    n_groups: int
    n_programs: int
    n_runs: int
    left_out: Notice | None


class BundlesToMerge(Body):
    """Files to bring in, one after the other."""

    paths: Annotated[list[_Path], Field(min_length=1, max_length=500)]
    delete: Annotated[bool, Field(description="delete here too what was deleted there")] = False


class MergedCounts(Shape):
    """How many came, went or were held back."""

    groups: int
    programs: int
    versions: int
    runs: int


class PendingDeletion(Shape):
    """What was deleted for good on another PC and is here still, until the teacher says so too."""

    groups: int
    programs: int
    runs: int
    names: Annotated[list[str], Field(description="of classes and groups, not more than a few")]


class Merged(Shape):
    """What came of one file: what it brought, or why it was refused.

    `held_back` is what stays out as it was deleted for good, `removed` what went now; null where there is none, and all
    numbers 0 where it is neither group, program, version nor run.

    `would_delete` is what it says was deleted elsewhere: it stays until the file is merged with `delete`. The files
    `left_in` may still hold it then: they were written on this PC, or are backups that could not be written anew.
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
    would_delete: PendingDeletion | None = None
    left_in: list[str] = Field(default=[])
    problem: Notice | None = None


class MergeList(Shape):
    """In the order of the files; `content_hash` is the same on every PC that holds the same work."""

    merged: list[Merged]
    content_hash: str


class NameOfFile(Body):
    """What the file is called where it was chosen, for the words about it."""

    name: Annotated[str, Field(max_length=1000)] = ""


class BroughtProgram(Shape):
    """A program that came as a file, and whose it is."""

    program_id: Id
    group_id: Id
    classroom_id: Id | None
    nothing_new: bool


class HeardComputer(Shape):
    """A PC whose work is here: when it wrote what came last, and when that came."""

    computer_id: Id
    name: str
    exported_at: Time
    merged_at: Time
    n_runs: int


class HeardList(Shape):
    """The one heard of last first."""

    computers: list[HeardComputer]


class WrittenFile(Shape):
    """A bundle that was written on this PC, and when."""

    path: str
    made_at: Time


class Removed(Shape):
    """What was deleted for good, from the file and its backups.

    These may still hold it: `backups` that could not be written anew, `files` that were written on this PC.
    """

    n_groups: int
    n_programs: int
    n_runs: int
    backups: list[str]
    files: list[WrittenFile]
