"""Opens the app's database. If it is unusable, opens a store without a file, whose notice has the reason."""

from pathlib import Path

from pinel_desktop.database_locations import is_location_missing, is_temporary, record_location
from pinel_desktop.paths import is_in_default_folder
from pinel_desktop.settings import RESETS, Settings
from storage import Notice, Store, StoreError, open_store
from storage.file.filesystems import is_in_memory
from storage.file.private import restrict_permissions

# Notices that do not prevent writing: the file is usable, or a remedy was applied.
WRITABLE_NOTICES = (
    "database_set_aside",
    "database_restored",
    "database_salvaged",
    "database_salvaged_alone",
    "database_end_salvaged",
    "database_gone",
    "database_gone_kept",
    "database_gone_restored",
    "database_gone_salvaged",
    "database_earlier",
    "database_earlier_backup",
    "database_on_share",
    "database_not_lasting",
    "backup_no_room",
    "backup_failed",
    "backup_share_failed",
    "backup_found_damage",
    "settings_mended",
)


def open_database(database: Path) -> Store:
    """Opens the store of the file; a store without a file if the file is unusable, or its folder is missing."""
    try:
        if is_location_missing(database):
            folder = str(database.parent)
            raise StoreError("database_place_missing", path=str(database), folder=folder)
        store = open_store(database, close_interrupted=True)
        restrict_permissions(database, is_own_folder=is_in_default_folder(database))
        record_location(database)
        if store.notice is None and not is_lasting(database):
            store.notice = Notice("database_not_lasting", {"folder": str(database.parent)})
        return store
    except StoreError as error:
        if error.code == "database_locked":  # waiting does not help: the file is opened only here
            error = StoreError("database_locked_at_start", **error.params)
        return Store.without_file(database, error)


def is_lasting(database: Path) -> bool:
    """Returns False for a database that is lost when the PC ends. Who chose a temporary folder knows that."""
    if is_in_default_folder(database):
        return not (Settings.beside(database)[RESETS] or is_in_memory(database.parent))
    return is_temporary(database) or not is_in_memory(database.parent)
