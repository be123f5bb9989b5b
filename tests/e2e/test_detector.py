"""A detector in place of the landmarks, by clicks: the teacher adds it, a group's program is decided by its signs."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.python_pane import write_program
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_camera import CAMERA_MS
from tests.e2e.test_classes import PIN, prepare, to_part
from tests.e2e.watch import Watch
from tests.gestures.colour_detector import GREEN, write_detector, write_pictures

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(180)]

B_OR_A = """\
robot.classify_gestures(timeout=60)
if robot.gesture_result == "B":
    robot.move_forward(0.2)
elif robot.gesture_result == "A":
    robot.turn(90)
"""


@pytest.fixture
def app(tmp_path: Path) -> Iterator[AppProcess]:
    app = AppProcess(tmp_path, "--camera", str(write_pictures(tmp_path / "pictures", GREEN)))
    app.start()
    yield app
    app.stop()


def test_a_detector_of_the_teacher_decides_what_a_program_does(
    studio: Studio, watch: Watch, tmp_path: Path
) -> None:
    watch.expect("422 (UNPROCESSABLE ENTITY)")  # response for the file that is no detector
    prepare(studio)
    to_part(studio, "camera")
    (tmp_path / "text.onnx").write_text("no model")
    studio["detector-file"].set_input_files(tmp_path / "text.onnx")
    expect(studio.page.get_by_role("alert")).to_contain_text("text.onnx", timeout=CAMERA_MS)
    expect(studio["detector-choice"]).to_have_value("")
    studio["detector-file"].set_input_files(write_detector(tmp_path / "cores.onnx"))
    expect(studio["detector-signs"]).to_contain_text("A, B", timeout=CAMERA_MS)
    expect(studio["detector-choice"]).to_have_value("cores")
    expect(studio["camera-picture"].locator("rect").first).to_be_visible(timeout=CAMERA_MS)
    expect(studio["camera-ready"]).to_have_attribute("data-ready", "true", timeout=CAMERA_MS)
    assert violations(studio, "detector-choice") == []
    studio["sign-out"].click()

    studio.enter_new_group()
    write_program(studio, B_OR_A)
    studio.run()
    studio.wait_for_phase("finished", RUN_MS + CAMERA_MS)
    studio.expect_number("pose-x", pytest.approx(0.2, abs=0.001))
    expect(studio["status-line"]).to_contain_text("A câmera viu B (")

    studio.page.goto(f"{studio.origin}/#/teacher/camera")
    studio["pin"].fill(PIN)
    studio["sign-in"].click()
    studio["detector-remove"].click()
    expect(studio["detector-remove"]).to_have_count(0)
    expect(studio["detector-choice"]).to_have_value("")
