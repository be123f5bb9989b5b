"""Fuzzing: any text gives a program or faults with places inside it, without exceptions and in bounded time."""

import random
import time

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pinel_desktop.program.limits import MAX_BYTES
from pinel_desktop.program.python_text import read_python, write_python
from pinel_desktop.program.reading import read_document
from tests.in_time import in_time
from tests.python_text.languages import Document, documents
from tests.python_text.test_faults import ONE_FAULT
from tests.python_text.test_page import PAGE

MAX_READ_S = 30.0  # for 1 MiB of the worst there is, on a slow PC that does other things too
QUICK = settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))
PIECES = [
    *"()[]{}:;,.=+-*/%<>!#\\\"'@~^&| \t\n\r\f\x00\ufeff_",
    *(
        "\n    ",
        "\n        ",
        "'''",
        '"""',
        "**",
        "==",
        "<=",
        "\r\n",
        "é",
        "😀",
        "\ud800",
        "ｒobot",
    ),
    *(
        "robot.",
        "robot.turn(90)",
        "range(",
        "steps(1, 2)",
        "x",
        "x = ",
        "1",
        "-0.0",
        "1e999",
        "9**9**9",
    ),
    *(
        "def f(a):\n    ",
        "return ",
        "global x",
        "if x:\n    ",
        "elif x:\n    ",
        "else:\n    ",
        "while ",
    ),
    *(
        "for _ in ",
        "True",
        "not ",
        " and ",
        " or ",
        " if ",
        " else ",
        "lambda: ",
        "f'{x}'",
        "import os",
    ),
    *(
        "match x:\n    case 1:\n        pass",
        "class A:\n    pass",
        "async ",
        "await x",
        "# comment\n",
    ),
    *("__import__('os').system('ls')", "pass", "break", "\\\n", "0x", "1_000", "1j", "b'a'", "..."),
]


def check(text: str) -> None:
    """Reads a text and checks the properties of the result."""
    reading = read_python(text)
    lines = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    for fault in reading.faults:
        line, column = fault.params["line"], fault.params["column"]
        assert isinstance(line, int)
        assert isinstance(column, int)
        assert 1 <= line <= len(lines)
        assert 1 <= column <= len(lines[line - 1]) + 1
    assert (reading.document is None) == bool(reading.faults)
    if reading.document is not None:
        once = write_python(reading.document).text
        again = read_python(once).document
        assert again is not None, once
        assert write_python(again).text == once


@QUICK
@given(st.one_of(st.text(), st.lists(st.sampled_from(PIECES), max_size=30).map("".join)))
def test_any_text_is_read_or_has_faults(text: str) -> None:
    check(text)


def mutated(text: str, draw: random.Random) -> str:
    """A text with a few pieces put in, taken out, doubled or exchanged."""
    for _ in range(draw.randint(1, 4)):
        i = draw.randint(0, len(text))
        j = min(len(text), i + draw.choice([0, 1, 1, 3, 20]))
        piece = draw.choice([draw.choice(PIECES), "", text[i:j] * 2, text[j : j + 9]])
        text = text[:i] + piece + text[j:]
    return text


@QUICK
@given(documents(), st.integers(0, 2**32))
def test_any_program_with_slips_is_read_or_has_faults(document: Document, seed: int) -> None:
    read = read_document(document).document
    assert read is not None
    check(mutated(write_python(read).text, random.Random(seed)))


def test_some_programs_with_slips() -> None:
    read_programs_with_slips(0, 1.0)


@pytest.mark.fuzz
@pytest.mark.timeout(900)
def test_programs_with_slips_for_a_while(fuzz_s: float) -> None:
    read_programs_with_slips(time.time_ns() % 2**32, fuzz_s)


def read_programs_with_slips(seed: int, seconds: float) -> None:
    """Slips are made again in some of the texts that come of them, so that they get farther from what is right."""
    seeds = [PAGE, *(text for text, *_ in ONE_FAULT if len(text) < 500)]
    seeds += ["\n".join(line.split("`")[1] for line in PAGE.splitlines() if line.startswith("| `"))]
    first, end = seed, time.monotonic() + seconds
    while time.monotonic() < end:
        draw = random.Random(seed)
        text = mutated(draw.choice(seeds), draw)
        try:
            check(text)
        except Exception as error:
            raise AssertionError(f"seed {seed} from {first}: {text!r}") from error
        if len(text) < 3000 and draw.random() < 0.3:
            seeds[draw.randrange(len(seeds))] = text
        seed += 1


def _whole(piece: str, before: str = "", after: str = "") -> str:
    """A text as long as a text may be, made of one piece over and over."""
    room = MAX_BYTES - len((before + after).encode())
    return before + piece * (room // len(piece.encode())) + after


HUGE = {
    "one_line_of_sums": _whole("1+", "x=", "1"),
    "signs": _whole("~", "x=", "1"),
    "nots": _whole("not ", "x=", "x"),
    "dots": _whole(".x", "x"),
    "calls": _whole("()", "f"),
    "indices": _whole("[0]", "x"),
    "brackets": _whole("("),
    "closed_brackets": _whole("()"),
    "closing_brackets": _whole(")"),
    "quotes": _whole('"'),
    "three_quotes": _whole("'''\n"),
    "unclosed_text": _whole("a", "x = '"),
    "backslashes": _whole("\\", "x = '", "'"),
    "comments": _whole("#\n"),
    "commas": _whole("1,", "x = [", "]"),
    "signs_in_a_list": _whole("-1,", "x = [", "]"),
    "short_commands": _whole("a;"),
    "commands": _whole("robot.stop()\n"),
    "bad_commands": _whole("é=é.é\n"),
    "bad_lines": _whole("x x\n"),
    "one_bad_line_of_accents": _whole("é.é;"),
    "elifs": _whole("elif x:\n pass\n", "if x:\n pass\n"),
    "elses": _whole("x if x else ", "x = ", "x"),
    "lambdas": _whole("lambda:", "x=", "1"),
    "equals": _whole("a=", "", "1"),
    "comparisons": _whole("a<", "x=", "1"),
    "ands": _whole("a and ", "x = ", "a"),
    "digits": _whole("9", "x = "),
    "hex_digits": _whole("f", "x = 0x"),
    "newlines": _whole("\n"),
    "form_feeds": _whole("\f\n"),
    "tabs": _whole("\t", "", "x = 1"),
    "accents": _whole("é"),
    "surrogates": "\ud800" * 300_000,
    "nulls": _whole("\x00"),
    "indented": "".join(" " * i + "while x:\n" for i in range(1000)),
    "functions": _whole("def f(): pass\n"),
    "formats": _whole("f'{x}'", "x="),
    "nested_formats": "x = " + "f'{" * 100 + "}'" * 100,
    "dictionaries": "x = " + "{" * 79 + "}" * 79,
    "exponents": "x = 9**9**9**9**9",
}


@pytest.mark.parametrize("name", sorted(HUGE))
def test_long_texts_of_the_worst_kinds_are_answered_in_time(name: str) -> None:
    answered_in_time(HUGE[name][:30_000])


@pytest.mark.nightly
@pytest.mark.parametrize("name", sorted(HUGE))
def test_the_longest_texts_of_the_worst_kinds_are_answered_in_time(name: str) -> None:
    answered_in_time(HUGE[name])


def answered_in_time(text: str) -> None:
    begin = time.monotonic()
    check(text)
    assert in_time(time.monotonic() - begin, MAX_READ_S)
