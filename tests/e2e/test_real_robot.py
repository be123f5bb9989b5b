"""A real robot in a lesson: set up, chosen, checked, driven, stopped by the emergency key, and reviewed."""

import contextlib
from collections.abc import Iterator, Mapping

import pytest
from playwright.sync_api import Locator, expect

from tests.e2e.axe import violations
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_classes import PIN, open_lesson, prepare, to_part
from tests.e2e.test_layout import cut
from tests.e2e.test_missions import begin
from tests.e2e.test_tour import covers
from tests.e2e.watch import Watch
from tests.links.aurora import Aurora, free_port
from tests.links.dds_domains import own_domain
from tests.links.double_process import Double

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(300)]

SPEED_MPS = 0.4
NEAR_THE_EDGE = {"max_v_mps": "0,4", "room.x_m": "-1,5"}
FAST_IN_A_HALL = {
    "max_v_mps": "1,2",
    "max_omega_dps": "250",
    "room.width_m": "8",
    "room.depth_m": "8",
}


@contextlib.contextmanager
def client(port: int) -> Iterator[Aurora]:
    """A client of the bridge for one run; it ends with its run, like the original's client."""
    aurora = Aurora(port)
    try:
        yield aurora
    finally:
        aurora.close()


def field(studio: Studio, name: str) -> Locator:
    return studio.page.locator(f"[data-testid=robot-field][data-name='{name}']")


def set_up(studio: Studio, port: int, fields: Mapping[str, str] = NEAR_THE_EDGE) -> None:
    """Types the teacher's settings of a robot."""
    to_part(studio, "robot")
    studio.page.locator("[data-testid=robot-kind][data-value=bridge]").click()
    studio["robot-limits"].click()
    for name, typed in {"port": str(port), **fields}.items():
        field(studio, name).fill(typed)
    studio["robot-keep"].click()
    expect(studio["robot-forget"]).to_be_visible()


def check_off(studio: Studio) -> None:
    """Ticks all points of the check list and runs."""
    expect(studio["before-go"]).to_be_disabled()
    studio.wait_for_screen("before-point")
    for point in studio["before-point"].all():
        point.check()
    studio["before-go"].click()


def build_move(studio: Studio, metres: str) -> None:
    blocks = studio.blocks
    blocks.drag_from_toolbox("motion", "andar para frente", blocks.below(blocks.start()))
    blocks.type_into(blocks.by_text("andar para frente"), metres)
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
    expect(studio["robot-state"]).to_contain_text(f"Esperando o simulador em 127.0.0.1:{port}")
    expect(studio["emergency-stop"]).to_be_visible()
    expect(studio["speed"]).to_have_count(0)
    expect(studio["world"]).to_have_count(0)
    with client(port) as aurora:
        expect(studio["robot-state"]).to_contain_text("Conectado", timeout=RUN_MS)
        expect(studio.page.locator(".floor__room")).to_have_text("Sala de verdadeConectado")
        studio["run"].click()
        expect(studio["before-run"]).to_contain_text("devagar, a 0,20 m/s")
        expect(studio["status-line"]).to_contain_text("confiram a lista")
        assert not covers(studio["before-run"], studio["scene"])
        assert violations(studio, "before-run") == []
        assert cut(studio, "before-run") == []
        studio.page.keyboard.press("Escape")
        expect(studio["before-run"]).to_have_count(0)
        expect(studio["run"]).to_be_focused()
        studio["run"].click()
        check_off(studio)
        studio.wait_for_phase("finished")
        assert aurora.has_ended(RUN_MS / 1000)
        assert 0.1 < max(twist.v_mps for _, twist in aurora.received) <= SPEED_MPS / 2

    studio.blocks.type_into(studio.blocks.by_text("andar para frente"), "2,5")
    studio.eventually(lambda: studio.values("distance"), [2.5])
    with client(port) as aurora:
        studio.run()  # the check list is needed once only
        expect(studio["before-run"]).to_have_count(0)
        studio.wait_for_phase("running")
        studio.eventually(lambda: studio.number("pose-x") > 0.2, True)
        studio.page.keyboard.press("F9")
        studio.wait_for_phase("stopped")
        assert aurora.has_ended(RUN_MS / 1000)
        assert aurora.standstill_since_s() is not None
        assert aurora.received[-1][1].v_mps == 0.0

    review(studio)


def sign_in_from_home(studio: Studio) -> None:
    studio["home"].click()
    studio["teacher-link"].click()
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    expect(studio["sign-out"]).to_be_visible()


def review(studio: Studio) -> None:
    """The teacher finds both runs with the robot's name, and the room in the replay."""
    sign_in_from_home(studio)
    studio.page.goto(f"{studio.origin}/#/runs")
    expect(studio["history-run"]).to_have_count(2)
    studio.expect_each(studio["history-run"], "data-outcome", ("stopped", "finished"))
    for run in (studio["history-run"].first, studio["history-run"].last):
        expect(run.get_by_test_id("robot-name")).to_have_text("Robô pela ponte")
        expect(run).to_contain_text("Sala de verdade")
    studio["history-run"].last.get_by_role("link").click()
    expect(studio.page.locator(".replay__tools").get_by_test_id("robot-name")).to_be_visible()


def test_a_mission_driven_on_the_robot_is_judged_by_what_it_measured(studio: Studio) -> None:
    port = free_port()
    prepare(studio)
    set_up(studio, port, FAST_IN_A_HALL)
    to_part(studio, "lessons")
    open_lesson(studio, "Quadrado", "square")
    studio["sign-out"].click()
    studio.enter_group("Os Tatus")
    expect(studio["how-judged"]).to_have_count(0)
    studio["robot-choice"].select_option("bridge")
    expect(studio["how-judged"]).to_have_attribute("data-state", "will_be")
    studio.build_square("1")
    with client(port) as aurora:
        studio["run"].click()
        check_off(studio)
        expect(studio["mission-done"]).to_be_visible(timeout=RUN_MS)
        assert aurora.has_ended(RUN_MS / 1000)
    expect(studio["how-judged"]).to_have_text("Avaliada pelo que o robô mediu.")
    assert violations(studio, "how-judged") == []
    assert cut(studio, "how-judged") == []
    begin(studio, "maze")
    expect(studio["how-judged"]).to_have_attribute("data-state", "not_judged")
    expect(studio["how-judged"]).to_contain_text("precisa do simulador (lugares do mundo)")
    judged_in_review(studio)


def judged_in_review(studio: Studio) -> None:
    """Lesson and replay show the teacher that the robot's measurements were judged."""
    sign_in_from_home(studio)
    (line,) = studio.api("/runs")["runs"]
    studio.page.goto(f"{studio.origin}/#/lesson/{line['lesson_id']}")
    expect(studio["review-group"]).to_have_attribute("data-need", "passed")
    studio["review-open"].click()
    run = studio["review-run"]
    expect(run).to_have_attribute("data-outcome", "passed")
    expect(run).to_contain_text("Robô pela ponte · avaliada pelo que o robô mediu")
    assert violations(studio, "review-run") == []
    assert cut(studio, "review-run") == []
    run.get_by_role("link").click()
    expect(studio["how-judged"]).to_have_attribute("data-state", "by_robot")
    assert cut(studio, "how-judged") == []


def test_teacher_tries_whether_the_robot_responds(studio: Studio) -> None:
    port = free_port()
    prepare(studio)
    set_up(studio, port)
    with client(port) as aurora:
        studio["robot-contact"].click()
        expect(studio["robot-found"]).to_contain_text("O robô responde", timeout=RUN_MS)
        assert not any(twist.v_mps or twist.omega_radps for _, twist in aurora.received)
    assert violations(studio, "robot-found") == []
    assert cut(studio, "robot-found") == []


@contextlib.contextmanager
def pioneer() -> Iterator[int]:
    """A Pioneer on DDS; yields its domain."""
    with own_domain() as domain:
        double = Double(domain)
        try:
            yield domain
        finally:
            double.close()


def test_teacher_finds_the_robot_moves_it_by_a_held_key_and_makes_its_place_the_start(
    studio: Studio,
) -> None:
    with pioneer() as domain:
        prepare(studio)
        to_part(studio, "robot")
        studio.page.locator("[data-testid=robot-kind][data-value=dds]").click()
        expect(studio["robots-find"]).to_be_in_viewport()
        expect(field(studio, "domain")).to_be_hidden()
        studio["robot-address"].click()
        for name, typed in {"domain": domain, "peers": "127.0.0.1", "command_topic": "x"}.items():
            field(studio, name).fill(str(typed))
        studio["robots-find"].click()
        studio["robot-use"].click(timeout=RUN_MS)
        expect(field(studio, "command_topic")).to_have_value("cmd_vel")
        studio["robot-keep"].click()
        expect(studio.page.get_by_role("status").filter(has_text="Salvo.")).to_be_visible()
        expect(studio["robot-now"]).to_contain_text("Conectado · bateria 80%", timeout=RUN_MS)

        hold_until_moved(studio)
        assert violations(studio, "robot-now") == []
        assert cut(studio, "robot-now") == []
        make_its_place_the_start(studio)

        studio["sign-out"].click()
        studio.enter_group("Os Tatus")
        build_move(studio, "0,2")
        studio["robot-choice"].select_option("dds")
        expect(studio["robot-state"]).to_contain_text("Conectado", timeout=RUN_MS)
        studio["run"].click()
        check_off(studio)
        studio.wait_for_phase("finished")
        expect(studio["robot-state"]).to_contain_text("Conectado · bateria 80%", timeout=RUN_MS)


def hold_until_moved(studio: Studio) -> None:
    """Presses the arrow key until the robot has moved, and releases it; the robot stops."""
    studio.page.locator("[data-testid=jog][data-direction=back]").focus()
    studio.page.keyboard.down("ArrowUp")
    expect(studio.page.locator("[data-testid=jog][data-direction=ahead]")).to_have_attribute(
        "aria-pressed", "true"
    )
    expect(studio["emergency-stop"]).to_be_visible(timeout=RUN_MS)
    studio.eventually(lambda: place(studio)[0] > 0.2, True)
    studio.page.keyboard.up("ArrowUp")
    # after the release of the key
    expect(studio["emergency-stop"]).to_have_count(0, timeout=RUN_MS)
    let_go = place(studio)
    studio.eventually(lambda: is_still(studio), True)  # it brakes, and the picture follows
    rest_pose = place(studio)
    assert abs(rest_pose[0] - let_go[0]) < 0.1


def is_still(studio: Studio) -> bool:
    """True if the drawn robot stays at rest so long that no further pose can arrive."""
    before = place(studio)
    studio.page.wait_for_timeout(1500)
    return place(studio) == before


def is_used_as_start(studio: Studio) -> bool:
    """Uses the robot's pose as the start; returns whether the form has the pose that is drawn."""
    studio["robot-here"].click()
    return field(studio, "room.x_m").input_value() == f"{place(studio)[0]:g}".replace(".", ",")


def place(studio: Studio) -> tuple[float, float]:
    """Position of the drawn robot in the room, in m."""
    drawn = studio["robot-place"].get_attribute("transform") or ""
    x, y = drawn.partition("(")[2].partition(")")[0].split(" ")
    return float(x), -float(y)


def make_its_place_the_start(studio: Studio) -> None:
    studio.eventually(lambda: is_used_as_start(studio), True)  # after a late pose
    x, _ = place(studio)
    studio["robot-keep"].click()
    expect(studio.page.get_by_role("status").filter(has_text="Salvo.")).to_be_visible()
    studio.eventually(lambda: abs(place(studio)[0] - x) < 0.03, True)


def test_wrong_field_is_named_and_a_forgotten_robot_is_offered_no_more(
    studio: Studio, watch: Watch
) -> None:
    watch.expect("422")
    watch.expect("/real-robots/bridge/watch")  # the page may request it while it is deleted
    prepare(studio)
    to_part(studio, "robot")
    studio.page.locator("[data-testid=robot-kind][data-value=bridge]").click()
    studio["robot-limits"].click()
    field(studio, "max_v_mps").fill("12")
    studio["robot-keep"].click()
    fault = studio.page.get_by_role("alert")
    expect(fault).to_contain_text("“12” não serve em “Velocidade máxima (m/s)”")
    expect(fault).to_contain_text("de 0,05 a 1,2")
    assert violations(studio, fault) == []
    assert cut(studio, fault) == []
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
    for screen, shown in {"studio": "run", "work": "program-card"}.items():
        expect(studio["emergency-stop"]).to_be_in_viewport(ratio=1)
        assert cut(studio, shown) == [], screen
        assert violations(studio, shown) == []
        if screen == "studio":
            studio["open-work"].click()
    studio["home"].click()
    studio.enter_group("Os Tatus")
    expect(studio["robot-choice"]).to_have_value("sim")  # each group chooses its robot itself
    expect(studio["emergency-stop"]).to_have_count(0)
