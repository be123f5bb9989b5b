"""The plots of a run: live beside the floor, in the replay with the slider, and saved as files."""

import csv
import io
import json
from pathlib import Path

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.blocks import box_of
from tests.e2e.conftest import OpenStudio
from tests.e2e.made_program import enter_made_group
from tests.e2e.studio import Studio

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(120)]

_PNG = b"\x89PNG\r\n\x1a\n"
_AXIS_PX = 60  # width of the numbers beside a plot


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def show(studio: Studio, figure: str) -> None:
    studio["plots-toggle"].click()
    studio.page.locator(f'[data-testid="plot-tab"][data-figure="{figure}"]').click()


def drive(studio: Studio) -> None:
    """Drives half a metre, to the end of the run."""
    enter_made_group(studio, [("move_forward", 0.5)], speed=10)
    studio.run()
    studio.wait_for_phase("finished")


def test_plots_grow_while_the_robot_drives(studio: Studio) -> None:
    enter_made_group(studio, [("move_forward", 2)])
    studio["plots-toggle"].click()
    expect(studio["plots"]).to_contain_text("Rodar")
    studio.run()
    expect(studio["plot"]).to_be_visible()
    first = int(studio["plots"].get_attribute("data-more") or 0)
    studio.page.wait_for_function(
        f"() => Number(document.querySelector('[data-testid=plots]').dataset.more) > {first + 2}"
    )
    studio["stop"].click()
    studio.wait_for_phase("stopped")


def test_plot_and_slider_of_a_replay_move_each_other(studio: Studio) -> None:
    drive(studio)
    open_replay(studio)
    show(studio, "position")
    slider, plot = studio["replay-slider"], studio["plot"]

    slider.fill("20")
    expect(plot).to_have_attribute("data-tick", "20")

    box = box_of(plot)
    middle = box["x"] + (box["width"] + _AXIS_PX) / 2
    studio.page.mouse.move(middle, box["y"] + 40)
    expect(slider).not_to_have_value("20")
    pointed = slider.input_value()
    studio.page.mouse.move(box["x"] + 5, box["y"] - 60)
    expect(slider).to_have_value("20")

    studio.page.mouse.click(middle, box["y"] + 40)
    studio.page.mouse.move(box["x"] + 5, box["y"] - 60)
    expect(slider).to_have_value(pointed)

    plot.focus()
    studio.page.keyboard.press("ArrowRight")
    expect(slider).to_have_value(str(int(pointed) + 3))


def test_every_plot_of_a_replay_is_drawn(studio: Studio) -> None:
    drive(studio)
    open_replay(studio)
    for figure in ("heading", "speed", "turning", "path"):
        if figure == "heading":
            show(studio, figure)
        else:
            studio.page.locator(f'[data-testid="plot-tab"][data-figure="{figure}"]').click()
        expect(studio["plot"]).to_have_attribute("data-figure", figure)
        studio.eventually(lambda: inked(studio), True)


def test_the_table_holds_what_the_run_measured(studio: Studio) -> None:
    drive(studio)
    show(studio, "speed")
    studio["plot-save"].click()
    with studio.page.expect_download() as download:
        studio["plot-table"].click()
    assert download.value.suggested_filename == "programa-1.csv"
    text = Path(download.value.path()).read_text("utf-8-sig")
    rows = list(csv.DictReader(io.StringIO(text), delimiter=";"))
    assert rows[-1]["x obtido (m)"] == "0,5000"
    assert float(rows[1]["tempo (s)"].replace(",", ".")) == pytest.approx(2 / 30, abs=1e-3)
    assert max(float(row["v comandado (m/s)"].replace(",", ".")) for row in rows) > 0.1


def test_the_picture_of_a_plot_is_white_whatever_the_theme(
    studio: Studio, open_studio: OpenStudio
) -> None:
    drive(studio)
    studio["theme"].click()  # dark
    show(studio, "position")
    studio["plot-save"].click()
    with studio.page.expect_download() as download:
        studio["plot-picture"].click()
    assert download.value.suggested_filename == "programa-1-posicao.png"
    picture = Path(download.value.path()).read_bytes()
    assert picture.startswith(_PNG)
    assert pixel(studio, picture, 5, 5) == [255, 255, 255, 255]


def open_replay(studio: Studio) -> None:
    group = studio.api("/groups")["groups"][0]["id"]
    run = studio.api(f"/groups/{group}/runs?limit=1")["runs"][0]["id"]
    studio.page.goto(studio.page.url.split("#")[0] + f"#/run/{run}")
    expect(studio["replay-slider"]).to_be_visible()


def inked(studio: Studio) -> bool:
    """True if the plot has drawn pixels."""
    return bool(
        studio.page.evaluate(
            """() => {
                const plot = document.querySelector('[data-testid=plot] canvas');
                const canvas = new OffscreenCanvas(plot.width, plot.height);
                const ctx = canvas.getContext('2d', {willReadFrequently: true});
                ctx.drawImage(plot, 0, 0);
                const {data} = ctx.getImageData(0, 0, plot.width, plot.height);
                return data.some((value, index) => index % 4 === 3 && value > 0);
            }"""
        )
    )


def pixel(studio: Studio, picture: bytes, x: int, y: int) -> list[int]:
    """Returns the colour of a point of a picture, as the browser decodes it."""
    found = studio.page.evaluate(
        """async ([bytes, x, y]) => {
            const image = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
            const canvas = new OffscreenCanvas(image.width, image.height);
            const ctx = canvas.getContext('2d');
            ctx.drawImage(image, 0, 0);
            return JSON.stringify([...ctx.getImageData(x, y, 1, 1).data]);
        }""",
        [list(picture), x, y],
    )
    return list(json.loads(found))
