from typing import Any

from tests.web.browser import Browser

SQUARE = {
    "pinel_ir": 1,
    "name": "square",
    "commands": [
        {
            "action": "repeat",
            "times": 4,
            "block": "r",
            "commands": [
                {"action": "move_forward", "distance": 1, "block": "m"},
                {"action": "turn", "angle": -90, "block": "t"},
            ],
        }
    ],
}


def without_blocks(value: Any) -> Any:
    if isinstance(value, list):
        return [without_blocks(item) for item in value]
    if isinstance(value, dict):
        return {key: without_blocks(item) for key, item in value.items() if key != "block"}
    return value


def test_a_document_is_written_with_the_block_of_each_line(browser: Browser) -> None:
    written = browser.post("/api/python", {"document": SQUARE}).data
    lines = written["text"].splitlines()
    places = {lines[line["line"] - 1].strip(): line["block"] for line in written["lines"]}
    assert places["for _ in range(4):"] == "r"
    assert places["robot.turn(-90)"] == "t"
    assert written["faults"] == []


def test_a_document_with_faults_is_not_written(browser: Browser) -> None:
    spoilt = {**SQUARE, "commands": [{"action": "turn", "angle": 9999, "block": "b"}]}
    written = browser.post("/api/python", {"document": spoilt}).data
    assert (written["text"], written["lines"]) == (None, [])
    assert [fault["block"] for fault in written["faults"]] == ["b"]


def test_what_was_written_is_read_as_it_was(browser: Browser) -> None:
    text = browser.post("/api/python", {"document": SQUARE}).data["text"]
    read = browser.post("/api/python/read", {"text": text}).data
    assert read["faults"] == []
    again = browser.post("/api/python", {"document": read["document"]}).data["text"]
    assert again == text
    assert without_blocks(read["document"]["commands"])[0]["times"] == 4


def test_faults_of_a_text_tell_line_and_column_in_words(browser: Browser) -> None:
    read = browser.post("/api/python/read", {"text": "robot.beep()\nimport os\nrobot.fly()\n"}).data
    assert read["document"] is None
    assert [fault["params"]["line"] for fault in read["faults"]] == [2, 3]
    assert all(fault["message"] and fault["remedy"] for fault in read["faults"])
    assert all(fault["params"]["column"] >= 1 for fault in read["faults"])
