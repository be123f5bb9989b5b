"""The app's way to its database: whatever is wrong with it, there is a store, which says so."""

from pathlib import Path

from pinel_desktop.database_locations import is_location_missing, record_location
from pinel_desktop.paths import is_in_default_folder
from storage import Store, StoreError, open_store
from storage.file.private import restrict_permissions

# All is well again, or a remedy was applied: the file is written to.
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
    "backup_no_room",
    "backup_failed",
    "backup_share_failed",
    "backup_found_damage",
    "settings_mended",
)


def open_database(database: Path) -> Store:
    """The store of the file; one without file where it cannot be used, or its folder is away."""
    try:
        if is_location_missing(database):
            folder = str(database.parent)
            raise StoreError("database_place_missing", path=str(database), folder=folder)
        store = open_store(database, close_interrupted=True)
        restrict_permissions(database, is_own_folder=is_in_default_folder(database))
        record_location(database)
        return store
    except StoreError as error:
        return Store.without_file(database, error)
