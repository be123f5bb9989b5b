"""The board game of experiment 6, played by clicks: X is signed, O is answered on the screen, the robot draws marks."""

import pytest
from playwright.sync_api import expect

from tests.e2e.app_process import AppProcess
from tests.e2e.axe import violations
from tests.e2e.studio import RUN_MS, Studio
from tests.e2e.test_examples import open_example
from tests.e2e.test_show import newest_run

pytestmark = [pytest.mark.e2e, pytest.mark.timeout(300)]

GAME_MS = 20_000


@pytest.fixture
def app(lasting_app: AppProcess) -> AppProcess:
    return lasting_app


def open_game(studio: Studio, name: str = "board_game") -> None:
    studio.enter_new_group()
    open_example(studio, name)
    expect(studio["world"]).to_have_value("tic_tac_toe")
    studio["speed"].select_option("10")
    studio.run()


def sign(studio: Studio, letter: str) -> None:
    expect(studio["capture"]).to_be_visible(timeout=GAME_MS)
    studio.page.locator(f"[data-testid=capture-letter][data-letter='{letter}']").click()


def answer(studio: Studio, cell: str) -> None:
    expect(studio["question-text"]).to_have_text("O joga: em que casa?", timeout=GAME_MS)
    studio["answer"].fill(cell)
    studio["send-answer"].click()


def expect_status(studio: Studio, text: str) -> None:
    expect(studio["status-line"]).to_contain_text(text, timeout=GAME_MS)


def marks(studio: Studio) -> list[tuple[str, str]]:
    """Returns the marks announced to people who cannot see the floor: symbol and zone."""
    label = studio["scene"].get_attribute("aria-label") or ""
    _, _, spoken = label.partition("Marcas no chão: ")
    spoken = spoken.partition(".")[0]
    return [(one[0], one[-1]) for one in spoken.split("; ") if one]


def test_a_game_is_played_to_x_won_with_a_taken_cell_and_an_unknown_letter(
    studio: Studio,
) -> None:
    open_game(studio)
    expect(studio["program-name"]).to_have_value("Jogo da velha")
    sign(studio, "A")
    answer(studio, "e")
    expect(studio["last-mark"]).to_have_text("O marcado em E", timeout=GAME_MS)
    sign(studio, "L")
    answer(studio, "A")
    expect_status(studio, "Casa ocupada por “X”: joguem de novo.")
    answer(studio, "D")
    sign(studio, "E")
    expect_status(studio, "Casa ocupada por “O”: joguem de novo.")
    sign(studio, "G")
    answer(studio, "H")
    expect_status(studio, "Não há casa “H”: joguem de novo.")
    answer(studio, "B")
    sign(studio, "")
    expect_status(studio, "Não há casa “”: joguem de novo.")
    sign(studio, "I")
    studio.wait_for_phase("finished", GAME_MS)
    expect(studio["talk-line"].last).to_contain_text("X ganhou!")
    studio.eventually(lambda: marks(studio), [*zip("XOXOXOX", "AELDGBI", strict=True)])
    assert violations(studio, "talk-line") == []

    studio.page.goto(f"{studio.page.url.split('#')[0]}#/run/{newest_run(studio)}")
    slider = studio["replay-slider"]
    expect(slider).to_be_visible(timeout=RUN_MS)
    studio.eventually(lambda: len(marks(studio)), 0)
    slider.fill(slider.get_attribute("max") or "")
    studio.eventually(lambda: len(marks(studio)), 7)


def test_a_game_without_a_line_ends_as_a_draw(studio: Studio) -> None:
    open_game(studio)
    for x, o in (("A", "B"), ("C", "D"), ("E", "G"), ("I", "L")):
        sign(studio, x)
        answer(studio, o)
    sign(studio, "F")
    studio.wait_for_phase("finished", GAME_MS)
    expect(studio["talk-line"].last).to_contain_text("Deu velha!")
    studio.eventually(lambda: len(marks(studio)), 9)


def test_a_mission_with_the_board_begins_with_the_part_of_x_and_shows_the_board_while_it_asks(
    studio: Studio,
) -> None:
    studio.enter_new_group()
    studio["open-activities"].click()
    studio.page.locator("[data-activity=x_against_list]").click()
    expect(studio["mission-sheet"]).to_contain_text("A parte do X já está pronta.")
    expect(studio.blocks.by_text("levar a marca").first).to_be_attached()
    studio.run()
    expect(studio["mission-sheet"]).to_be_hidden()
    expect(studio["capture"]).to_be_visible(timeout=GAME_MS)
    board, panel = studio["scene"].bounding_box(), studio["capture"].bounding_box()
    assert board is not None
    assert panel is not None
    assert board["width"] > 200
    assert board["height"] > 200
    assert panel["x"] < board["x"]
    assert board["x"] + board["width"] < panel["x"] + panel["width"]
    assert violations(studio, "capture") == []
    sign(studio, "A")
    expect(studio["last-mark"]).to_have_text("X marcado em A", timeout=GAME_MS)
    studio["stop"].click()
