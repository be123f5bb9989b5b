"""The first start in an account: sets up the new database by the PC's set-up file."""

import sys
from pathlib import Path

from pinel_desktop.database_locations import is_location_missing
from pinel_desktop.instance import InstanceLock


def setup_file_path(platform: str = sys.platform, program: str = sys.executable) -> Path:
    """Returns where an installer puts the set-up file.

    On Windows it is beside the program. Into a folder of %ProgramData% every account could put one.
    """
    if platform == "win32":
        return Path(program).parent / "setup" / "pinel.toml"
    return Path("/etc/pinel/pinel.toml")


SETUP_FILE = setup_file_path()


def locked(database: Path) -> InstanceLock:
    """Acquires the lock on a database, and sets up a new one. Raises as `InstanceLock.acquire`."""
    instance = InstanceLock(database)
    instance.acquire()
    set_up_if_new(database)
    return instance


def set_up_if_new(database: Path) -> None:
    """Sets up a database that does not exist yet; call it with the lock on the database.

    A fault is printed, and the app starts without the file: a lesson must not wait for a technician.
    """
    if database.exists() or not SETUP_FILE.is_file() or is_location_missing(database):
        return
    # only the first start needs these
    from pinel_desktop.commands.printing import print_problem  # noqa: PLC0415
    from pinel_desktop.errors import PinelError  # noqa: PLC0415
    from pinel_desktop.school.pc_setup import PcSetupError, apply, read_pc_setup  # noqa: PLC0415
    from pinel_desktop.settings import Settings  # noqa: PLC0415
    from storage import StoreError, open_store  # noqa: PLC0415

    try:
        setup = read_pc_setup(SETUP_FILE)
        with open_store(database) as store:
            apply(setup, store, Settings.beside(database))
    except PcSetupError as error:
        for fault in error.faults:
            print_problem(fault)
    except (PinelError, StoreError) as problem:
        print_problem(problem)
