"""The dialog for saving files that the page creates, in GTK's window."""

from collections.abc import Callable, Mapping
from typing import Any


def install_save_dialog(context: Any, parent: Any, texts: Callable[[], Mapping[str, str]]) -> None:
    """Shows a save dialog for each download of the web view's `context`.

    Args:
        texts: texts by pywebview's keys, in the chosen language.
    """

    def start(_context: Any, download: Any) -> None:
        download.connect("decide-destination", decide)

    def decide(download: Any, suggested: str) -> bool:
        path = ask_for_path(parent, suggested, texts())
        if path is None:
            download.cancel()
        else:
            download.set_allow_overwrite(True)  # the dialog has confirmed it
            download.set_destination(_address(path))
        return True

    context.connect("download-started", start)


def ask_for_path(parent: Any, suggested: str, texts: Mapping[str, str]) -> str | None:
    """Shows the dialog; returns the path that the person chooses for a file, None if cancelled."""
    from gi.repository import GLib, Gtk  # noqa: PLC0415 - optional, see backends.gtk_problem

    dialog = Gtk.FileChooserDialog(
        title=texts["global.saveFile"], parent=parent, action=Gtk.FileChooserAction.SAVE
    )
    dialog.add_buttons(
        texts["global.cancel"],
        Gtk.ResponseType.CANCEL,
        texts["global.saveFile"],
        Gtk.ResponseType.ACCEPT,
    )
    folder = GLib.get_user_special_dir(GLib.UserDirectory.DIRECTORY_DOWNLOAD)
    dialog.set_current_folder(folder or GLib.get_home_dir())
    dialog.set_current_name(suggested)
    dialog.set_do_overwrite_confirmation(True)
    try:
        chosen = dialog.run() == Gtk.ResponseType.ACCEPT
        return str(dialog.get_filename()) if chosen else None
    finally:
        dialog.destroy()


def _address(path: str) -> str:
    from gi.repository import GLib  # noqa: PLC0415

    return str(GLib.filename_to_uri(path))
