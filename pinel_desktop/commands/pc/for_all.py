"""`pinel setup --system`: the set-up file for every account of the PC, and the start at login."""

import shutil
from pathlib import Path

from pinel_desktop.commands.pc import first_start
from pinel_desktop.school.pc_setup import PcSetup

# read by the desktops of Linux at each login
AUTOSTART = Path("/etc/xdg/autostart/pinel-desktop.desktop")
_ENTRY = """[Desktop Entry]
Type=Application
Name=PINEL
Exec=pinel
Icon=pinel-desktop
"""


def install_for_all(file: Path, setup: PcSetup) -> None:
    """Copies the file and its lesson to where each account's first start reads them.

    Raises OSError without the right to write there.
    """
    folder = first_start.SETUP_FILE.parent
    folder.mkdir(mode=0o755, parents=True, exist_ok=True)
    for source, target in ((file, first_start.SETUP_FILE), (setup.lesson, None)):
        if source is not None:
            copy = target or folder / source.name
            if not (copy.exists() and copy.samefile(source)):
                shutil.copyfile(source, copy)
            copy.chmod(0o644)
    if setup.at_login:
        AUTOSTART.parent.mkdir(parents=True, exist_ok=True)
        AUTOSTART.write_text(_ENTRY, "utf-8")
    elif setup.at_login is False:
        AUTOSTART.unlink(missing_ok=True)
