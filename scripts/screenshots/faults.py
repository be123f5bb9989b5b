"""Faults that a page shows without eyes: cut texts, covered controls, and what axe finds."""

from playwright.sync_api import Page

from tests.e2e.axe import violations_now
from tests.e2e.layout_faults import layout_faults


def faults(page: Page, is_main: bool) -> list[str]:
    """Returns the faults of a page; axe does not depend on the size, and judges no paper."""
    is_paper = page.evaluate("matchMedia('print').matches")
    return [*layout_faults(page), *(violations_now(page) if is_main and not is_paper else [])]
