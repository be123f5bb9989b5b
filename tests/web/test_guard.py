"""Accepted and refused requests of the guard."""

from collections.abc import Callable
from urllib.parse import urlsplit

import pytest

from pinel_desktop.app import App
from pinel_desktop.web.guard import KEY_S, Guard
from tests.web.browser import Browser

GROUPS = "/api/groups"


def at(app: App, template: str) -> str:
    return template.format(port=urlsplit(app.address).port)


@pytest.mark.parametrize(
    ("headers", "status", "code"),
    [
        ({"Cookie": ""}, 401, "key_missing"),
        ({"Cookie": "pinel_{port}=guessed"}, 401, "key_missing"),
        ({"Host": "localhost:{port}"}, 421, "host_wrong"),
        ({"Host": "127.0.0.1"}, 421, "host_wrong"),
        ({"Host": "127.0.0.1:1"}, 421, "host_wrong"),
        ({"Host": "evil.example:{port}"}, 421, "host_wrong"),
        ({"Host": "evil..example"}, 421, "host_wrong"),  # no valid DNS name
        ({"Origin": "http://evil.example"}, 403, "origin_wrong"),
        ({"Origin": "http://localhost:{port}"}, 403, "origin_wrong"),
        ({"Origin": "https://127.0.0.1:{port}"}, 403, "origin_wrong"),
        ({"Origin": "null"}, 403, "origin_wrong"),
        ({"Sec-Fetch-Site": "cross-site"}, 403, "cross_site"),
        ({"Sec-Fetch-Site": "same-site"}, 403, "cross_site"),
    ],
)
@pytest.mark.parametrize("method", ["GET", "POST"])
def test_what_our_page_did_not_send_is_refused(
    app: App, browser: Browser, method: str, headers: dict[str, str], status: int, code: str
) -> None:
    forged = {name: at(app, value) for name, value in headers.items()}
    answer = browser.send(
        method, GROUPS, {"name": "A"} if method == "POST" else None, headers=forged
    )
    assert (answer.status, answer.error["code"]) == (status, code)
    assert "Access-Control-Allow-Origin" not in answer.headers
    assert browser.get(GROUPS).data == {"groups": []}


@pytest.mark.parametrize(
    "headers",
    [{"Origin": "http://127.0.0.1:{port}"}, {"Sec-Fetch-Site": "none"}, {"Sec-Fetch-Site": ""}],
)
def test_what_our_page_sent_is_answered(
    app: App, browser: Browser, headers: dict[str, str]
) -> None:
    own = {name: at(app, value) for name, value in headers.items()}
    assert browser.get(GROUPS, own).status == 200


def test_a_key_opens_the_page_once_and_leaves_the_address(app: App) -> None:
    address = app.address
    browser = Browser.at(address)
    path = address.partition(str(browser.port))[2]
    first, second = browser.get(path), browser.get(path)
    assert (first.status, first.headers["Location"]) == (302, "/")
    assert second.status == 401
    assert "Set-Cookie" not in second.headers


def test_the_cookie_is_out_of_reach_of_scripts_and_of_other_sites(app: App) -> None:
    address = app.address
    browser = Browser.at(address)
    cookie = browser.get(address.partition(str(browser.port))[2]).headers["Set-Cookie"]
    assert cookie.startswith(f"pinel_{browser.port}=")
    assert "HttpOnly" in cookie
    assert "SameSite=Strict" in cookie


def test_a_used_key_is_harmless_where_the_page_is_open_already(app: App) -> None:
    address = app.address
    browser = Browser.signed_in(address)
    assert browser.get(address.partition(str(browser.port))[2]).status == 302


def test_any_use_but_head_uses_a_key_up(app: App) -> None:
    open_page = Browser.signed_in(app.address)
    uses: dict[str, Callable[[str], object]] = {
        "at the API": lambda path: Browser.at(app.address).get(f"/api/status{path[1:]}"),
        "from another site": lambda path: Browser.at(app.address).get(path, {"Origin": "http://x"}),
        "where the page is open": open_page.get,
        "by another method": lambda path: Browser.at(app.address).send("POST", path),
    }
    for use in uses.values():
        address = app.address
        path = address.partition(str(open_page.port))[2]
        use(path)
        assert Browser.at(address).get(path).status == 401
    address = app.address
    path = address.partition(str(open_page.port))[2]
    assert Browser.at(address).send("HEAD", path).status == 401
    assert Browser.at(address).get(path).status == 302


def test_a_key_expires() -> None:
    now = [0.0]
    guard = Guard(clock=lambda: now[0])
    early, late = (guard.fresh_link().partition("key=")[2] for _ in range(2))
    now[0] = KEY_S
    assert guard.redeem(early)
    now[0] = KEY_S + 0.1
    assert not guard.redeem(late)


def test_a_key_does_not_open_the_api(app: App) -> None:
    address = app.address
    browser = Browser.at(address)
    query = address.partition("?")[2]
    assert browser.get(f"{GROUPS}?{query}").status == 401


@pytest.mark.parametrize(
    "path", ["/", "/index.html", "/assets/x.js", "/api/status", "/api/stream", "/no"]
)
def test_without_the_cookie_nothing_is_told_about_anything(app: App, path: str) -> None:
    assert Browser.at(app.address).get(path).status == 401


def test_what_a_person_sees_without_the_key_is_a_page_in_words(app: App) -> None:
    answer = Browser.at(app.address).get("/")
    assert answer.headers["Content-Type"].startswith("text/html")
    assert "pinel serve" in answer.text


@pytest.mark.parametrize("what", ["link", "open", "show"])
@pytest.mark.parametrize("secret", ["", "guessed", "não-ascii"])
def test_another_start_without_the_secret_is_refused(app: App, what: str, secret: str) -> None:
    browser = Browser.at(app.address)
    headers = {"X-Pinel-Secret": secret.encode().decode("latin-1")}
    answer = browser.send("POST", f"/api/instance/{what}", headers=headers)
    assert (answer.status, answer.error["code"]) == (401, "secret_wrong")


def test_the_cookie_does_not_stand_in_for_the_secret(browser: Browser) -> None:
    assert browser.post("/api/instance/link").status == 401


def test_two_apps_on_one_pc_do_not_take_each_other_s_cookie(
    start_app: Callable[..., App], app: App
) -> None:
    other = start_app(app._database.with_name("other.db"))
    mine, theirs = Browser.signed_in(app.address), Browser.signed_in(other.address)
    both = f"{mine.headers['Cookie']}; {theirs.headers['Cookie']}"
    assert mine.get(GROUPS, {"Cookie": both}).status == 200
    assert theirs.get(GROUPS, {"Cookie": both}).status == 200
    assert theirs.get(GROUPS, {"Cookie": mine.headers["Cookie"]}).status == 401


def test_a_head_with_the_cookie_the_secret_or_a_key_is_known_and_uses_up_none() -> None:
    guard = Guard()
    guard.bind("127.0.0.1", 8400)
    link = guard.fresh_link()
    assert guard.is_known(
        f"GET /x HTTP/1.1\r\nCookie: a=b; pinel_8400={guard.cookie_value}".encode()
    )
    assert guard.is_known(f"POST /x HTTP/1.1\r\nX-Pinel-Secret: {guard.secret}\r\n".encode())
    assert guard.is_known(f"GET {link.partition('8400')[2]} HTTP/1.1\r\n".encode())
    assert guard.redeem(link.partition("=")[2])
    assert not guard.is_known(f"GET {link.partition('8400')[2]} HTTP/1.1\r\n".encode())
    assert not guard.is_known(f"Cookie: pinel_8400={guard.cookie_value[:-1]}\xff".encode("latin-1"))
