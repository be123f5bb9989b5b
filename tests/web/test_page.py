"""The page's files, and the message shown without them."""

import html
import json
from collections.abc import Callable
from pathlib import Path

import pytest

from pinel_desktop.app import App
from pinel_desktop.command_name import command_name
from pinel_desktop.messages import LANGUAGES
from pinel_desktop.settings import Settings
from pinel_desktop.web import page
from tests.web.browser import Browser


@pytest.fixture
def built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "static"
    (folder / "assets").mkdir(parents=True)
    for name in ("index.html", *(f"index.{language}.html" for language in LANGUAGES)):
        (folder / name).write_text(f"<!doctype html><html lang='x'><title>{name}</title>", "utf-8")
    (folder / "assets" / "index-4f2a.js").write_text("export {}", "utf-8")
    (folder.parent / "secret.txt").write_text("not yours", "utf-8")
    monkeypatch.setattr(page, "STATIC", folder)
    return folder


def test_the_page_is_asked_for_anew_each_time_and_its_assets_never(
    built: Path, browser: Browser
) -> None:
    index, asset = browser.get("/"), browser.get("/assets/index-4f2a.js")
    assert index.headers["Content-Type"] == "text/html; charset=utf-8"
    assert index.headers["Cache-Control"] == "no-cache"
    assert asset.headers["Content-Type"].startswith("text/javascript")
    assert "immutable" in asset.headers["Cache-Control"]


def test_the_page_is_the_one_with_the_texts_of_the_chosen_language(
    built: Path, browser: Browser
) -> None:
    for language in LANGUAGES:
        browser.put("/api/settings", {"language": language})
        assert f"index.{language}.html" in browser.get("/").text


@pytest.mark.parametrize("theme", ["", "dark"])
def test_a_file_that_did_not_change_is_not_sent_again(
    built: Path, browser: Browser, theme: str
) -> None:
    browser.put("/api/settings/page", {"name": "pinel_theme", "value": theme})
    tag = browser.get("/").headers["ETag"]
    again = browser.get("/", {"If-None-Match": tag})
    assert (again.status, again.body) == (304, b"")
    browser.put("/api/settings/page", {"name": "pinel_theme", "value": "contrast"})
    assert browser.get("/", {"If-None-Match": tag}).status == 200


def test_the_page_comes_with_its_settings_and_in_its_theme(
    built: Path, browser: Browser, start_app: Callable[..., App], app: App
) -> None:
    chosen = {"pinel_theme": "dark", "pinel_turns": "5"}
    for name, value in chosen.items():
        assert browser.put("/api/settings/page", {"name": name, "value": value}).status == 200
    settings = html.escape(json.dumps(Settings().of_page() | chosen))
    command = html.escape(command_name())
    expected = (
        f"""<html lang='x' data-settings="{settings}" data-command="{command}" data-theme="dark">"""
    )
    assert expected in browser.get("/").text
    app.close()
    again = Browser.signed_in(start_app().address)
    assert expected in again.get("/").text


@pytest.mark.parametrize(
    "setting",
    [
        {"name": "pinel_theme", "value": '"><script>'},
        {"name": "Theme!", "value": "dark"},
        {"name": "pinel_theme", "value": "green"},
        {"name": "pinel_camera", "value": "1"},
        {"name": "pinel_class", "value": "x" * 4001},
        {"name": "pinel_theme"},
    ],
)
def test_a_setting_that_the_page_cannot_have_made_is_refused(
    browser: Browser, setting: dict[str, str]
) -> None:
    assert browser.send("PUT", "/api/settings/page", setting).status == 422


@pytest.mark.parametrize(
    "path", ["/../secret.txt", "/..%2fsecret.txt", "/assets/../../secret.txt", "/assets/no.js"]
)
def test_nothing_outside_the_page_s_folder_is_served(
    built: Path, browser: Browser, path: str
) -> None:
    answer = browser.get(path)
    assert answer.status == 404
    assert "not yours" not in answer.text


def test_a_page_that_was_not_built_says_what_to_do(
    tmp_path: Path, browser: Browser, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "STATIC", tmp_path / "none")
    answer = browser.get("/")
    assert answer.status == 503
    assert "make run" in answer.text
    assert "<style" not in answer.text  # the security policy refuses it


@pytest.mark.parametrize("path", ["/", "/api/status", "/api/nothing", "/nothing"])
def test_every_answer_carries_the_headers_that_keep_the_page_to_itself(
    built: Path, browser: Browser, path: str
) -> None:
    headers = browser.get(path).headers
    policy = dict(part.split(" ", 1) for part in headers["Content-Security-Policy"].split("; "))
    assert policy["default-src"] == "'self'"
    assert policy["img-src"] == "'self' data:"
    assert [name for name, value in policy.items() if "unsafe" in value] == ["style-src-attr"]
    assert {"script-src", "style-src"}.isdisjoint(policy)  # so both fall back to 'self'
    assert headers["Referrer-Policy"] == "no-referrer"
    assert headers["X-Content-Type-Options"] == "nosniff"


def test_nothing_of_the_api_is_cached(browser: Browser) -> None:
    assert browser.get("/api/status").headers["Cache-Control"] == "no-store"
