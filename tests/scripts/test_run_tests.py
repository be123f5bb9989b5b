"""The sums at the end of `make test` tell the truth."""

import sys
import tomllib
from pathlib import Path

import psutil
import pytest

from tests.packaging.loading import load

run_tests = load("scripts/run_tests.py")
PYTEST = run_tests.Step("unit", "test", ("pytest",), counts=True)
LINT = run_tests.Step("ruff", "lint", ("ruff",))


def outcome(step: object, output: str, status: int = 0) -> object:
    return run_tests.StepResult(step, status, 1.0, output)


@pytest.mark.parametrize(
    ("output", "expected"),
    [
        ("..\n12 passed in 0.50s\n", (12, 0, 0)),
        ("=== 1 failed, 11 passed, 2 skipped in 61.20s (0:01:01) ===\n", (11, 1, 2)),
        ("3 passed, 1 warning, 2 errors in 1.00s\n", (3, 2, 0)),
        ("2 passed, 5 deselected, 1 xfailed in 1.00s\n", (2, 0, 1)),
        (" Test Files  4 passed (4)\n      Tests  31 passed | 2 skipped (33)\n", (31, 0, 2)),
        ("      Tests  1 failed | 30 passed (31)\n", (30, 1, 0)),
    ],
)
def test_the_closing_lines_of_both_runners_are_counted(
    output: str, expected: tuple[int, int, int]
) -> None:
    failing = 1 if expected[1] else 0
    assert tuple(run_tests.totals([outcome(PYTEST, output, failing)]).values()) == expected


def test_sums_are_over_all_runners_and_the_last_closing_line_of_each() -> None:
    quoted = "E   1 failed in 2.00s\n4 passed in 1.00s\n"
    assert (
        run_tests.totals([outcome(PYTEST, quoted), outcome(PYTEST, "2 passed in 1.00s\n")])[
            "passed"
        ]
        == 6
    )


@pytest.mark.parametrize("output", ["", "no tests ran in 0.01s\n", "5 deselected in 0.10s\n"])
def test_a_runner_that_ran_nothing_has_failed(output: str) -> None:
    assert outcome(PYTEST, output).failed  # type: ignore[attr-defined]
    assert run_tests.totals([outcome(PYTEST, output)]) == {"passed": 0, "failed": 1, "skipped": 0}


def test_a_linter_that_fails_counts_as_one_failure() -> None:
    assert run_tests.totals([outcome(LINT, "Found 20 errors.\n", 1)])["failed"] == 1


def test_a_runner_that_breaks_off_counts_as_one_failure() -> None:
    assert run_tests.totals([outcome(PYTEST, "Segmentation fault\n", -11)])["failed"] == 1
    assert run_tests.totals([outcome(PYTEST, "3 passed in 1.00s\n", 1)]) == {
        "passed": 3,
        "failed": 1,
        "skipped": 0,
    }


@pytest.fixture(scope="module")
def markers() -> list[str]:
    """Those that a step asks for."""
    settings = tomllib.loads((run_tests.ROOT / "pyproject.toml").read_text("utf-8"))
    lines = settings["tool"]["pytest"]["ini_options"]["markers"]
    return [line.partition(":")[0] for line in lines]


def test_a_marker_stands_in_the_file_of_its_tests(markers: list[str]) -> None:
    """Steps look for it there: a test that got its marker elsewhere would never run."""
    others = (run_tests.ROOT / "tests").rglob("*.py")
    texts = {
        file: file.read_text("utf-8")
        for file in others
        if not file.name.startswith(("test_", "bench_"))
    }
    assert not [file for file, text in texts.items() for one in markers if f"mark.{one}" in text]
    for marker in markers:
        assert run_tests.files_with(marker)


def test_every_test_is_in_exactly_one_step() -> None:
    """A marker that no step asks for would be a test that never runs."""
    chosen = [
        step.command[step.command.index("-m", 3) + 1]
        for step in run_tests.STEPS
        if step.command[:3] == run_tests.PYTEST[:3]
    ]
    assert chosen == [
        "not e2e and not packaged and not nightly and not fuzz and not waits",
        "waits and not nightly",
        "fuzz",
        "e2e and not nightly",
        "packaged and not nightly",
        "nightly",
        "e2e and not nightly",  # behind a slow line
        "fuzz",  # for longer
    ]


def test_the_slowest_tests_of_all_steps_are_named() -> None:
    outputs = [
        "12.50s setup    tests/a/test_a.py::test_one\n0.90s call     tests/b.py::test_two[a b]\n",
        "30.01s call     tests/c.py::test_three\n1.00s of a text that a test printed\n",
    ]
    assert run_tests.by_duration([outcome(PYTEST, output) for output in outputs]) == [
        (30.01, "tests/c.py::test_three"),
        (12.5, "tests/a/test_a.py::test_one"),
        (0.9, "tests/b.py::test_two[a b]"),
    ]


def test_at_most_ten_are_named() -> None:
    output = "".join(f"{n}.00s call     tests/a.py::test_{n}\n" for n in range(20))
    assert len(run_tests.by_duration([outcome(PYTEST, output)])) == 10


def test_a_step_aside_is_there_before_the_next_one_of_its_group(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(run_tests, "LOGS", tmp_path)
    waits = "import os, time\nwhile not os.path.exists('done'): time.sleep(0.01)"
    steps = [
        run_tests.Step("build", "package", python(tmp_path, waits), is_aside=True),
        run_tests.Step("unit", "test", python(tmp_path, "open('done', 'w')")),
        run_tests.Step("smoke", "package", python(tmp_path, "print('ok')")),
    ]
    outcomes = run_tests.run_all(steps)
    assert [(one.step.name, one.failed) for one in outcomes] == [
        ("unit", False),
        ("build", False),
        ("smoke", False),
    ]


def python(folder: Path, code: str) -> tuple[str, ...]:
    """The command line of Python that does it in the folder."""
    return (sys.executable, "-c", f"import os; os.chdir({str(folder)!r})\n{code}")


def test_busy_loops_end_with_what_they_run_beside() -> None:
    def loops() -> list[psutil.Process]:
        children = psutil.Process().children()
        return [one for one in children if one.cmdline()[-1:] == ["while True: pass"]]

    with run_tests.busy_loops(2):
        assert len(loops()) == 2
    assert loops() == []
