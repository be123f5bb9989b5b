"""The icon of the window has the pixels of the page's drawing."""

import base64

import pytest
from playwright.sync_api import Browser

from tests.packaging.loading import ROOT

pytestmark = pytest.mark.e2e

PUBLIC = ROOT / "ui" / "public"
MEAN_DIFFERENCE = """async (addresses) => {
  const drawn = await Promise.all(addresses.map(async (address) => {
    const image = new Image(256, 256);
    image.src = address;
    await image.decode();
    const context = new OffscreenCanvas(256, 256).getContext("2d");
    context.drawImage(image, 0, 0, 256, 256);
    return context.getImageData(0, 0, 256, 256).data;
  }));
  return drawn[0].reduce((sum, value, i) => sum + Math.abs(value - drawn[1][i]), 0) / drawn[0].length;
}"""


def test_the_icon_shows_what_the_drawing_shows(browser: Browser) -> None:
    kinds = {"favicon.svg": "image/svg+xml", "icon.png": "image/png"}
    addresses = [
        f"data:{kind};base64,{base64.b64encode((PUBLIC / name).read_bytes()).decode()}"
        for name, kind in kinds.items()
    ]
    page = browser.new_page()
    assert page.evaluate(MEAN_DIFFERENCE, addresses) < 2, "draw ui/public/icon.png anew, 256 x 256"
    page.close()
