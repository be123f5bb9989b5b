"""The program as Python text, as hands use it: opened, written, put into blocks."""

from playwright.sync_api import expect

from tests.e2e.studio import Studio


def open_python(studio: Studio) -> None:
    """Shows the program as Python."""
    if studio["ir-toggle"].get_attribute("aria-expanded") != "true":
        studio["ir-toggle"].click()
    expect(studio["python-edit"]).to_be_enabled()


def edit_python(studio: Studio, text: str) -> None:
    """Opens the text for writing and puts another in its place."""
    open_python(studio)
    studio["python-edit"].click()
    studio["python-editor"].fill(text)


def write_program(studio: Studio, text: str) -> None:
    """Makes the program that a Python text says, in blocks, and has it saved."""
    edit_python(studio, text)
    studio["python-put"].click()
    expect(studio["swap-back"]).to_be_visible()
    studio["ir-toggle"].click()
    studio.wait_until_saved()
