"""The robot models over HTTP."""

from pinel_desktop.robot import PIONEER_3DX, ROBOTS
from tests.web.browser import Browser


def test_robots_come_with_what_is_needed_to_draw_them_the_usual_one_first(browser: Browser) -> None:
    robots = browser.get("/api/robots").data["robots"]
    assert [robot["name"] for robot in robots] == list(ROBOTS)
    pioneer, small = robots[:2]
    assert pioneer["radius_m"] == PIONEER_3DX.radius_m
    assert len(pioneer["sonars"]) == 16
    assert pioneer["sonars"][0]["y_m"] == PIONEER_3DX.radius_m
    assert [wheel["y_m"] for wheel in pioneer["wheels"]] == [0.165, -0.165]
    assert (pioneer["laser"]["field_deg"], pioneer["laser"]["range_m"]) == (180, 8.0)
    assert small["radius_m"] == 0.08
    assert small["laser"] is None
