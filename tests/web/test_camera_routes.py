"""The camera over HTTP: its state, its choice, its picture and its result. A landmark sequence replaces the webcam."""

import http.client
from collections.abc import Iterator
from pathlib import Path

import pytest

from pinel_desktop.app import App
from tests.web.browser import Browser

RECORDING = Path(__file__).parents[1] / "camera" / "recordings" / "b.npz"
WAIT_S = 30.0


@pytest.fixture
def app(tmp_path: Path) -> Iterator[App]:
    with App(tmp_path / "pinel.db", camera=str(RECORDING)) as app:
        yield app


@pytest.fixture
def browser(app: App) -> Browser:
    return Browser.signed_in(app.address)


def test_camera_stays_off_until_somebody_looks_through_it(browser: Browser) -> None:
    off = {"state": "off", "source": str(RECORDING), "problem": None}
    assert browser.get("/api/camera").data == off
    assert browser.post("/api/camera/wake", {}).data == off


def test_preview_needs_the_cookie_and_is_a_stream_of_pictures(browser: Browser) -> None:
    assert Browser(browser.host, browser.port).get("/api/camera/preview").status == 401
    connection = http.client.HTTPConnection(browser.host, browser.port, timeout=WAIT_S)
    connection.request("GET", "/api/camera/preview", headers=browser.headers)
    answer = connection.getresponse()
    assert answer.headers["Content-Type"].startswith("multipart/x-mixed-replace; boundary=")
    assert answer.headers["Cache-Control"] == "no-store"
    begin = answer.read(200)
    assert b"Content-Type: image/jpeg\r\n\r\n\xff\xd8\xff" in begin
    connection.close()


@pytest.mark.parametrize("source", ["/etc/passwd", "-1", "12", "http://example.org/a.mp4", "", "٣"])
def test_only_a_webcam_can_be_chosen(browser: Browser, source: str) -> None:
    assert browser.put("/api/camera", {"source": source}).status == 422
    assert browser.get("/api/camera").data["source"] == str(RECORDING)


def test_chosen_camera_is_remembered_and_one_that_is_not_there_is_told(tmp_path: Path) -> None:
    for _ in range(2):
        with App(tmp_path / "pinel.db") as app:
            browser = Browser.signed_in(app.address)
            assert browser.put("/api/camera", {"source": "7"}).status == 200
        with App(tmp_path / "pinel.db") as app:
            browser = Browser.signed_in(app.address)
            assert browser.get("/api/camera").data["source"] == "7"
            with browser.stream() as stream:
                connection = http.client.HTTPConnection(browser.host, browser.port, timeout=WAIT_S)
                connection.request("GET", "/api/camera/preview", headers=browser.headers)
                while (event := stream.until("camera_state")[-1])["state"] != "failed":
                    pass
                assert event["code"] == "camera_missing"
                assert "8" in event["message"]
                assert event["params"] == {"number": 8}
                assert event["remedy"]
                problem = browser.get("/api/camera").data["problem"]
                assert problem == {name: event[name] for name in problem}
            connection.close()
