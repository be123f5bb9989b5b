"""Operates the Python pane: opens and edits the text, converts it to blocks."""

from playwright.sync_api import expect

from tests.e2e.studio import Studio


def open_python(studio: Studio) -> None:
    """Shows the program as Python."""
    if studio["ir-toggle"].get_attribute("aria-expanded") != "true":
        studio["ir-toggle"].click()
    expect(studio["python-edit"]).to_be_enabled()


def edit_python(studio: Studio, text: str) -> None:
    """Opens the editor and replaces the text."""
    open_python(studio)
    studio["python-edit"].click()
    studio["python-editor"].fill(text)


def write_program(studio: Studio, text: str) -> None:
    """Replaces the program by the program of a Python text, and waits until it is saved."""
    edit_python(studio, text)
    studio["python-put"].click()
    expect(studio["swap-back"]).to_be_visible()
    studio["ir-toggle"].click()
    studio.wait_until_saved()
