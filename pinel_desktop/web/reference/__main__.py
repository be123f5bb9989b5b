"""Writes the pages: `python -m pinel_desktop.web.reference`, from the repository's root."""

from pathlib import Path

from pinel_desktop.web.reference import events_page, http_page

DOCS = Path("docs")

if __name__ == "__main__":
    (DOCS / "http-api.md").write_text(http_page.text(), "utf-8")
    (DOCS / "events.md").write_text(events_page.text(), "utf-8")
