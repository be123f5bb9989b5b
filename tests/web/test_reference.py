"""The pages that are made from the code are current."""

from pathlib import Path

from pinel_desktop.web.reference import events_page, http_page

DOCS = Path(__file__).parents[2] / "docs"
AGAIN = "python -m pinel_desktop.web.reference"


def test_the_page_about_events_is_current() -> None:
    assert (DOCS / "events.md").read_text("utf-8") == events_page.text(), AGAIN


def test_the_page_about_the_http_interface_is_current() -> None:
    assert (DOCS / "http-api.md").read_text("utf-8") == http_page.text(), AGAIN
