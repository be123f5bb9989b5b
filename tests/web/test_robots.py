"""The robot models over HTTP."""

from pinel_desktop.robot import PIONEER_3DX, ROBOTS
from tests.web.browser import Browser


def test_robots_come_with_what_is_needed_to_draw_them_the_usual_one_first(browser: Browser) -> None:
    robots = browser.get("/api/robots").data["robots"]
    assert [robot["name"] for robot in robots] == list(ROBOTS)
    pioneer, small = robots
    assert pioneer["radius_m"] == PIONEER_3DX.radius_m
    assert len(pioneer["sonar_angles_rad"]) == 16
    assert small["radius_m"] == 0.08
    assert small["lidar_range_m"] is None
