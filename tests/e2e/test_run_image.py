"""A run saved as a picture with its blocks, or as an animation, for the group to keep and show."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from PIL import Image, ImageSequence
from playwright.sync_api import Download, expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.past_lesson import SQUARE, Step, document_of, workspace_of
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_layout import cut
from tests.e2e.test_show import newest_run

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(240)]

Pixels = npt.NDArray[np.int16]

PLUM, PLUM_RGB = "#a03561", (160, 53, 97)
MOTION_RGB = (41, 102, 186)  # blocks of movement
WHITE = 255
MAX_ANIMATION_BYTES = 4_000_000
MAX_ANIMATION_S = 20.5

# Records the texts that the page draws on canvases.
_RECORD_TEXTS = """() => {
  window.drawn = [];
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    window.drawn.push(text);
    return fillText.call(this, text, ...place);
  };
}"""


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def drive(studio: Studio, steps: list[Step], **setup: Any) -> None:
    """Runs a program of a new group to its end."""
    robot = {"color": PLUM, "robot_name": "Tucuxi", "robot_pattern": "plain"}
    name = studio.unique("Os Botos")
    group = studio.send("POST", "/groups", {"name": name, **robot})["id"]
    program = studio.send("POST", f"/groups/{group}/programs", {"name": "Volta"})["id"]
    version = {
        "workspace": workspace_of(steps),
        "document": document_of(steps),
        "setup": {"world": "empty_room", "speed": 10, **setup},
    }
    studio.send("POST", f"/programs/{program}/versions", version)
    studio.page.goto(f"{studio.origin}/#/program/{program}")
    studio.wait_until_open()
    studio.hurry()
    studio.run_to_the_end()


def save(studio: Studio, what: str) -> Download:
    studio["run-image"].click()
    with studio.page.expect_download(timeout=RUN_MS) as download:
        studio[f"save-run-{what}"].click()
    return download.value


def texts_of(studio: Studio, act: Callable[[], object]) -> list[str]:
    """Returns the texts that the page draws on canvases meanwhile."""
    studio.page.evaluate(_RECORD_TEXTS)
    act()
    drawn: list[str] = studio.page.evaluate("() => window.drawn")
    return [one.replace("\u00a0", " ") for one in drawn]


def frames_of(saved: Download) -> Iterator[tuple[Pixels, float]]:
    """The decoded frames of a picture, and the seconds for which each is shown."""
    with Image.open(saved.path()) as image:
        for frame in ImageSequence.Iterator(image):
            pixels = np.asarray(frame.convert("RGB"), dtype=np.int16)
            yield pixels, frame.info.get("duration", 0) / 1000


def pixels_of(saved: Download) -> Pixels:
    ((pixels, _),) = frames_of(saved)
    return pixels


def near(pixels: Pixels, colour: tuple[int, int, int], tolerance: int = 6) -> npt.NDArray[np.bool_]:
    """Whether each pixel has nearly this colour."""
    return np.asarray(abs(pixels - np.asarray(colour)).max(axis=2) <= tolerance)


def place_of(mask: npt.NDArray[np.bool_]) -> tuple[float, float]:
    rows, columns = np.nonzero(mask)
    assert len(rows) > 0, "no pixel has the colour"
    return float(columns.mean()), float(rows.mean())


def test_a_picture_has_floor_blocks_and_names_on_white_paper_in_any_theme(studio: Studio) -> None:
    drive(studio, SQUARE, activity="square")
    studio.eventually(lambda: studio.api(f"/runs/{newest_run(studio)}")["passed"], True)
    studio["theme"].click()
    expect(studio.page.locator("html")).to_have_attribute("data-theme", "dark")
    saved: list[Download] = []
    texts = texts_of(studio, lambda: saved.append(save(studio, "picture")))

    group = studio.api(f"/programs/{studio.program_id}")["group_id"]
    name = next(one["name"] for one in studio.api("/groups")["groups"] if one["id"] == group)
    assert {"Volta", name, "Tucuxi", "quando rodar"} <= set(texts)
    (mission,) = [one for one in studio.api("/activities")["activities"] if one["name"] == "square"]
    assert f"Missão cumprida: {mission['number']} {mission['title']}" in texts
    assert any(one.startswith("Robô Tucuxi · ") and one.endswith(" · PINEL") for one in texts)

    assert saved[0].suggested_filename == f"{name.lower().replace(' ', '-')}-volta.png"
    pixels = pixels_of(saved[0])
    height, width, _ = pixels.shape
    assert width == 2256
    assert 1200 < height < 1600
    edges = np.concatenate([pixels[:8], pixels[-8:]])
    assert edges.min() == WHITE
    assert near(pixels[:, : width // 2], PLUM_RGB).sum() > 500  # the robot
    assert near(pixels[:, width * 6 // 10 :], MOTION_RGB, 12).sum() > 50_000  # the blocks
    assert pixels[200:-60, 60 : width // 2].mean() > 220  # the floor is as light as by day
    assert violations(studio, "run-image") == []


def test_no_block_of_a_long_program_is_cut(studio: Studio) -> None:
    steps: list[Step] = [("move_forward", 0.1), ("turn", 12)] * 30
    drive(studio, steps)
    saved: list[Download] = []
    texts = texts_of(studio, lambda: saved.append(save(studio, "picture")))
    assert texts.count("andar para frente") == 30
    pixels = pixels_of(saved[0])
    assert pixels.shape[0] > 1512
    border = np.concatenate([pixels[-30:].reshape(-1, 3), pixels[:, -30:].reshape(-1, 3)])
    assert border.min() == WHITE


def test_an_animation_goes_from_the_start_to_the_end_of_a_run_in_twenty_seconds(
    studio: Studio,
) -> None:
    drive(studio, [*SQUARE, *SQUARE, *SQUARE, ("move_forward", 1.5)])  # a minute of robot time
    saved: list[Download] = []
    texts = texts_of(studio, lambda: saved.append(save(studio, "animation")))
    assert "4×" in texts
    assert saved[0].suggested_filename.endswith("-volta.gif")
    file = Path(saved[0].path())
    assert file.stat().st_size <= MAX_ANIMATION_BYTES
    assert file.read_bytes().endswith(b"\x00;")  # it is complete

    frames = [
        (near(floor[:, :490], PLUM_RGB, 12), shown_s) for floor, shown_s in frames_of(saved[0])
    ]
    assert len(frames) > 100
    assert 10 < sum(shown_s for _, shown_s in frames) <= MAX_ANIMATION_S
    (start_x, start_y), (end_x, end_y) = place_of(frames[0][0]), place_of(frames[-1][0])
    assert end_x - start_x > 60
    assert abs(end_y - start_y) < 20
    expect(studio["run-image"]).to_be_visible()


def test_an_animation_can_be_cancelled_and_the_page_is_usable_meanwhile(studio: Studio) -> None:
    drive(studio, SQUARE)
    downloads: list[Download] = []

    def on_download(download: Download) -> None:
        downloads.append(download)

    studio.page.on("download", on_download)
    studio["run-image"].click()
    studio["save-run-animation"].click()
    expect(studio["run-image-progress"]).to_contain_text("Animação:")
    studio["scene-tools"].click()  # the floor's tools answer meanwhile
    expect(studio["scene-picture"]).to_be_visible()
    studio["run-image-cancel"].click()
    expect(studio["run-image"]).to_be_visible()
    studio.run()  # a new run: nothing of the old one is saved later
    studio.wait_for_phase("finished")
    assert downloads == []


@pytest.mark.parametrize("size", [(1366, 768), (1024, 600), (683, 384)])
def test_the_replay_saves_the_same_picture_and_hides_nothing(
    studio: Studio, size: tuple[int, int]
) -> None:
    drive(studio, SQUARE[:2])
    run = newest_run(studio)
    studio.page.set_viewport_size({"width": size[0], "height": size[1]})
    assert cut(studio, "past-run") == []
    studio.page.goto(f"{studio.origin}/#/run/{run}")
    studio.wait_for_screen("replay-play")
    assert cut(studio, "run-image") == []
    assert save(studio, "picture").suggested_filename.endswith("-volta.png")


def test_a_picture_is_saved_by_the_keyboard(studio: Studio) -> None:
    drive(studio, SQUARE[:1])
    studio["run-image"].focus()
    studio.page.keyboard.press("Enter")
    studio.page.keyboard.press("Tab")
    expect(studio["save-run-picture"]).to_be_focused()
    with studio.page.expect_download() as download:
        studio.page.keyboard.press("Enter")
    assert download.value.suggested_filename.endswith("-volta.png")
    expect(studio["save-run-picture"]).to_have_count(0)
    expect(studio["run-image"]).to_be_focused()
