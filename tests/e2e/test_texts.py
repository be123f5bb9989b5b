"""The main screens with keys in place of all texts: any other text is hard-coded."""

import re
from typing import Any

import pytest
from playwright.sync_api import Page, Route, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.conftest import OpenStudio
from tests.e2e.review_school import Past, sign_in
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

# exports a language's texts, each replaced by its key in brackets, with the places of its values
_SHOWING_KEYS = """
import * as real from "{url}?real";
const shown = (value, path) => {{
  if (Array.isArray(value)) return value.map((one, index) => shown(one, `${{path}}.${{index}}`));
  if (typeof value === "object") {{
    const rows = Object.entries(value).map(([key, one]) => [key, shown(one, `${{path}}.${{key}}`)]);
    return Object.fromEntries(rows);
  }}
  if (!/\\p{{L}}/u.test(value)) return value;
  const isFunction = value.includes("{{{{");
  return [`⟦${{path}}${{isFunction ? " {{{{no}}}}" : ""}}⟧`, ...(value.match(/%\\d/g) ?? [])].join(" ");
}};
export const texts = shown(real.texts, "texts");
export const messages = shown(real.messages, "messages");
"""
_ATTRIBUTES = (
    "aria-label",
    "title",
    "placeholder",
    "alt",
    "aria-description",
    "aria-roledescription",
)
_SHOWN_TEXTS = """attributes => {
  const seen = [];
  for (const element of document.querySelectorAll("body *")) {
    if (element.closest("[lang]:not(html)") || !element.checkVisibility()) continue;
    for (const name of attributes) if (element.hasAttribute(name)) seen.push(element.getAttribute(name));
    for (const node of element.childNodes) if (node.nodeType === Node.TEXT_NODE) seen.push(node.data);
  }
  return seen;
}"""
# dates as the browser formats them in the page's language
_DAY = re.compile(r"(?i)(?:\b\w+(?:-feira|\.)?, )?\b\d\d?\sde\s\w+\.?(?:\sde\s\d{4})?")
# the program's own name, units, and names of axes and keys, which are equal in all languages
_UNTRANSLATED = re.compile(
    r"PINEL|F\d+|Esc|Ctrl|Shift|Enter|Space|Tab|\b(?:m|s|cm|kg|rad|min|x|y|v)\b"
)
_KEYS = re.compile(r"⟦[^⟧]*⟧")


def _show_keys(route: Route) -> None:
    url = route.request.url
    if url.endswith("?real"):
        route.continue_()
    else:
        body = _SHOWING_KEYS.format(url=url)
        route.fulfill(body=body, content_type="text/javascript")


def _hard_coded(page: Page, data: set[str]) -> set[str]:
    """Returns the screen's texts that are neither a key nor written by a person or a world's author."""

    def rest(text: str) -> str:
        text = _KEYS.sub("", text)
        for known in sorted(filter(lambda one: len(one) > 1, data), key=len, reverse=True):
            text = text.replace(known, "")
        text = _UNTRANSLATED.sub("", _DAY.sub("", text))
        return "" if text in data else text

    shown = [str(text) for text in page.evaluate(_SHOWN_TEXTS, _ATTRIBUTES)]
    return {text for text in shown if re.search(r"[^\W\d_]", rest(text))}


def _strings(value: Any) -> set[str]:
    """Returns all texts of a response of the server."""
    if isinstance(value, str):
        return {value}
    inside = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return {text for one in inside for text in _strings(one)}


def _lines(found: dict[str, set[str]]) -> list[str]:
    return [f"{screen}: {text}" for screen, texts in found.items() for text in sorted(texts)]


@pytest.fixture
def app(school: tuple[AppProcess, Past]) -> AppProcess:
    return school[0]


@pytest.fixture
def keys(open_studio: OpenStudio) -> Studio:
    studio = open_studio()
    studio.page.route(re.compile(r"/assets/(?:start|lazy)-[^/]*\.js(?:\?real)?$"), _show_keys)
    studio.page.reload()
    expect(studio["group-name"]).to_be_visible()
    return studio


def test_no_text_of_a_pupil_s_screen_is_written_into_the_code(keys: Studio) -> None:
    found: dict[str, set[str]] = {}

    def check(screen: str) -> None:
        found[screen] = _hard_coded(keys.page, _strings(keys.api("/groups")) | data)

    data = _strings([keys.api("/worlds"), keys.api("/classrooms"), keys.api("/robots")])
    check("start")
    keys.enter_new_group()
    data |= _strings(keys.api(f"/programs/{keys.program_id}"))
    check("studio")
    for button in ("scene-tools", "ir-toggle", "plots-toggle"):
        keys[button].click()
        check(button)
    keys["open-work"].click()
    keys["program-card"].first.wait_for()
    check("work")
    keys["work-album"].click()
    keys["album-place"].first.wait_for()
    data |= _strings(keys.api(f"/groups/{keys.page.url.rpartition('/')[2]}/album"))
    check("album")
    assert _lines(found) == []


def test_no_text_of_the_teacher_s_screens_is_written_into_the_code(
    keys: Studio, school: tuple[AppProcess, Past]
) -> None:
    found: dict[str, set[str]] = {}
    sign_in(keys)
    keys.page.reload()
    data = set[str]()
    for path in ("/groups", "/classrooms", "/activities", "/computer", "/worlds"):
        data |= _strings(keys.api(path))
    data |= _strings(keys.api(f"/lessons/{school[1].lesson}/review"))
    for place, ready in (
        ("teacher/lessons", "lesson-row"),
        ("teacher/classes", "class-group"),
        ("teacher/files", "shared-folder"),
        ("teacher/computer", "computer-name"),
        (f"lesson/{school[1].lesson}", "review-group"),
        ("runs", "history-run"),
    ):
        keys.page.goto(f"{keys.origin}#/{place}")
        expect(keys[ready].first).to_be_visible()
        found[place] = _hard_coded(keys.page, data)
    assert _lines(found) == []
