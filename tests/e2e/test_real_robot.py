"""A real robot in a lesson: set up by the teacher, chosen, checked, driven, stopped by the emergency key, reviewed."""

import contextlib
from collections.abc import Iterator

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.axe import violations
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import PIN, prepare, to_part
from tests.e2e.test_layout import cut
from tests.e2e.watch import Watch
from tests.links.aurora import Aurora, free_port

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(300)]

SPEED_MPS = 0.4


@contextlib.contextmanager
def client(port: int) -> Iterator[Aurora]:
    """A client of the bridge for one run; it ends with its run, as the original's does."""
    aurora = Aurora(port)
    try:
        yield aurora
    finally:
        aurora.close()


def field(studio: Studio, name: str) -> Locator:
    return studio.page.locator(f"[data-testid=robot-field][data-name='{name}']")


def set_up(studio: Studio, port: int) -> None:
    """What a teacher types for a robot that stands near an edge of its room."""
    to_part(studio, "robot")
    studio.page.locator("[data-testid=robot-kind][data-value=bridge]").click()
    for name, typed in {"port": str(port), "max_v_mps": "0,4", "room.x_m": "-1,5"}.items():
        field(studio, name).fill(typed)
    studio["robot-keep"].click()
    expect(studio["robot-forget"]).to_be_visible()


def check_off(studio: Studio) -> None:
    """Goes through the check list and runs."""
    expect(studio["before-go"]).to_be_disabled()
    for point in studio["before-point"].all():
        point.check()
    studio["before-go"].click()


def build_move(studio: Studio, metres: str) -> None:
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_words("andar para frente"), metres)
    studio.eventually(lambda: studio.values("distance"), [float(metres.replace(",", "."))])


def test_group_drives_the_robot_that_its_teacher_set_up_and_stops_it_by_the_emergency_key(
    studio: Studio,
) -> None:
    port = free_port()
    prepare(studio)
    set_up(studio, port)
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    build_move(studio, "0,5")
    expect(studio["real-robot"]).to_have_count(0)

    studio["robot-choice"].select_option("bridge")
    expect(studio["real-robot"]).to_contain_text("Robô de verdade")
    expect(studio["emergency-stop"]).to_be_visible()
    expect(studio["speed"]).to_have_count(0)
    expect(studio["world"]).to_have_count(0)
    with client(port) as aurora:
        studio["run"].click()
        expect(studio["before-run"]).to_contain_text("devagar, a 0,20 m/s")
        assert violations(studio) == []
        assert cut(studio.page) == []
        check_off(studio)
        studio.wait_for_phase("finished")
        assert aurora.has_ended(RUN_MS / 1000)
        assert 0.1 < max(twist.v_mps for _, twist in aurora.heard) <= SPEED_MPS / 2

    studio.blocks.type_into(studio.blocks.by_words("andar para frente"), "2,5")
    studio.eventually(lambda: studio.values("distance"), [2.5])
    with client(port) as aurora:
        studio.run()  # the list is gone through once
        expect(studio["before-run"]).to_have_count(0)
        studio.wait_for_phase("running")
        studio.eventually(lambda: studio.number("pose-x") > 0.2, True)
        studio.page.keyboard.press("F9")
        studio.wait_for_phase("stopped")
        assert aurora.has_ended(RUN_MS / 1000)
        assert aurora.stood_from_s() is not None
        assert aurora.heard[-1][1].v_mps == 0.0

    review(studio)


def review(studio: Studio) -> None:
    """The teacher finds both runs with the robot's name, and the room in the replay."""
    studio["home"].click()
    studio["teacher-link"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio["sign-out"]).to_be_visible()
    studio.page.goto(f"{studio.origin}/#/runs")
    expect(studio["history-run"]).to_have_count(2)
    for run, outcome in zip(studio["history-run"].all(), ("stopped", "finished"), strict=True):
        expect(run).to_have_attribute("data-outcome", outcome)
        expect(run.get_by_test_id("robot-name")).to_have_text("Robô pela ponte")
        expect(run).to_contain_text("Sala de verdade")
    studio["history-run"].last.get_by_role("link").click()
    expect(studio.page.locator(".replay__tools").get_by_test_id("robot-name")).to_be_visible()


def test_teacher_tries_whether_the_robot_responds(studio: Studio) -> None:
    port = free_port()
    prepare(studio)
    set_up(studio, port)
    with client(port) as aurora:
        studio["robot-contact"].click()
        expect(studio["robot-found"]).to_contain_text("O robô responde", timeout=RUN_MS)
        assert not any(twist.v_mps or twist.omega_radps for _, twist in aurora.heard)
    assert violations(studio) == []
    assert cut(studio.page) == []


def test_wrong_field_is_named_and_a_forgotten_robot_is_offered_no_more(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("422")
    prepare(studio)
    to_part(studio, "robot")
    studio.page.locator("[data-testid=robot-kind][data-value=bridge]").click()
    field(studio, "max_v_mps").fill("12")
    studio["robot-keep"].click()
    fault = studio.page.get_by_role("alert")
    expect(fault).to_contain_text("“12” não serve em “Velocidade máxima (m/s)”")
    expect(fault).to_contain_text("de 0,05 a 1,2")
    assert violations(studio) == []
    assert cut(studio.page) == []
    field(studio, "max_v_mps").fill("0,4")
    studio["robot-keep"].click()
    expect(studio["robot-forget"]).to_be_visible()
    studio["robot-forget"].click()
    expect(studio["robot-forget"]).to_have_count(0)
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    expect(studio["robot-choice"]).to_have_count(0)


def test_emergency_stop_stays_in_reach_on_every_screen_and_in_a_narrow_window(
    studio: Studio,
) -> None:
    prepare(studio)
    set_up(studio, free_port())
    studio["sign-out"].click()
    studio.enter_group("Os Engenheiros da Robótica")
    studio["robot-choice"].select_option("bridge")
    studio.page.set_viewport_size({"width": 1024, "height": 768})
    for screen in ("studio", "work"):
        expect(studio["emergency-stop"]).to_be_in_viewport(ratio=1)
        assert cut(studio.page) == [], screen
        assert violations(studio) == []
        if screen == "studio":
            studio["open-work"].click()
            expect(studio.page.get_by_role("heading", level=1)).to_be_visible()
    studio.page.reload()
    expect(studio["home"]).to_be_visible()
    expect(studio["emergency-stop"]).to_have_count(0)  # every page begins with the simulator
