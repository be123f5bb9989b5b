"""Runs every check of the repository and prints the totals.

Continues after failures, so that the log shows all of them. The output of each step is shown live and written to
build/test-logs. The last line is `N passed, N failed, N skipped` over all test runners.
"""

import argparse
import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LOGS = ROOT / "build" / "test-logs"
N_DURATIONS = 10
PYTEST = (sys.executable, "-m", "pytest", "-q", f"--durations={N_DURATIONS}")
_MEMORY_DISK = Path("/dev/shm")
_NEEDED_BYTES = 4 * 2**30
_N_CORES = os.cpu_count() or 1


def side_by_side(n_workers: int) -> tuple[str, ...]:
    """Options for parallel tests on `n_workers`; robots in real time run late on many more workers than cores."""
    return ("-n", str(min(n_workers, 12)), "--dist", "worksteal")


# a step that mostly waits needs more workers to use all cores
WORKING = side_by_side(_N_CORES + 1)
WAITING = side_by_side(4 * _N_CORES)
# another order of responses each night; the log shows the seed
LATE = f"--delay-requests={int(time.time())}"
_COLOURS = re.compile(r"\x1b\[[0-9;]*m")
# pytest: "3 passed, 1 skipped in 0.5s", between = without -q; vitest: "Tests  3 passed (3)"
_CLOSING = re.compile(
    r"^(?:=* ?\d+ \w+.* in [\d.]+s.*|=* ?no tests ran in .*|\s*Tests\s+\d+ .*\(\d+\))$", re.M
)
_DURATION = re.compile(r"^([\d.]+)s (?:call|setup|teardown) +(\S.*)$", re.M)
_COUNT = re.compile(r"(\d+) (passed|failed|errors?|skipped|xfailed|xpassed|todo)\b")
_SUM_OF = {
    "passed": "passed",
    "failed": "failed",
    "error": "failed",
    "errors": "failed",
    "xpassed": "failed",
    "skipped": "skipped",
    "xfailed": "skipped",
    "todo": "skipped",
}


@dataclass(frozen=True)
class Step:
    """One command.

    Attributes:
        counts: True for a test runner, whose summary line is parsed.
        is_aside: True if it runs in parallel with the steps after it, until the next step of its group.
        n_busy: busy loops that run in parallel with it, to find races.
    """

    name: str
    group: str
    command: Sequence[str]
    counts: bool = False
    is_aside: bool = False
    n_busy: int = 0


def environment() -> dict[str, str]:
    """Returns the environment of all steps.

    Python may write bytecode, so that hundreds of processes do not compile the same files again. If `_MEMORY_DISK` has
    enough space, temporary files are in memory: tests write thousands of small databases and need not wait for the
    disk.

    All processes get this temporary folder as `TMPDIR`. The app records the location of a database outside of `TMPDIR`,
    and a later test in a folder of the same name would report that database as missing.
    """
    found = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    if _MEMORY_DISK.is_dir() and _has_room(_MEMORY_DISK):
        found.setdefault("TMPDIR", str(_MEMORY_DISK))
    return found


def _has_room(disk: Path) -> bool:
    """True if a disk has space for all files of the tests and can execute programs."""
    state = os.statvfs(disk)
    return state.f_bavail * state.f_frsize > _NEEDED_BYTES and not state.f_flag & os.ST_NOEXEC


def npm(*arguments: str) -> tuple[str, ...]:
    """Returns the command line of npm in ui/, with a Node.js new enough for the page."""
    script = 'PATH="$(sh scripts/node.sh):$PATH" && cd ui && exec npm "$@"'
    return ("sh", "-c", script, "npm", *arguments)


def files_with(marker: str) -> list[str]:
    """Returns the test files with a marker, because each process needs 15 s to collect all tests."""
    files = sorted((ROOT / "tests").rglob("test_*.py"))
    return [
        str(file.relative_to(ROOT))
        for file in files
        if f"pytest.mark.{marker}" in file.read_text("utf-8")
    ]


def marked_tests(
    name: str, group: str, *options: str, only: str, without: str = "", n_busy: int = 0
) -> Step:
    """Returns a step of the tests with a marker `only`, without tests that also have the marker `without`."""
    markers = f"{only} and not {without}" if without else only
    command = (*PYTEST, *files_with(only), *options, "-m", markers)
    return Step(name, group, command, counts=True, n_busy=n_busy)


def mypy_for(platform: str) -> Step:
    """Returns a step that checks the types of the program, without its tests, for another system."""
    cache = f"--cache-dir=.mypy_cache/{platform}"  # else each platform would discard the other's
    folders = ("pinel_desktop", "sim", "storage")
    command = (sys.executable, "-m", "mypy", "--platform", platform, cache, *folders)
    return Step(f"mypy-{platform}", "lint", command)


UNIT = "not e2e and not packaged and not nightly and not fuzz and not waits"
STEPS = (
    Step("ruff", "lint", (sys.executable, "-m", "ruff", "check", ".")),
    Step("format", "lint", (sys.executable, "-m", "ruff", "format", "--check", ".")),
    Step("mypy", "lint", (sys.executable, "-m", "mypy")),
    mypy_for("win32"),
    mypy_for("darwin"),
    Step("import-rules", "lint", (str(Path(sys.executable).with_name("lint-imports")),)),
    Step("folders", "lint", (sys.executable, "scripts/figures.py", "--check")),
    Step("names", "lint", (sys.executable, "-m", "scripts.names")),
    Step("page-lint", "lint", npm("run", "--silent", "check")),
    Step("page-unit", "test", npm("run", "--silent", "test"), counts=True),
    Step("unit", "test", (*PYTEST, *WORKING, "-m", UNIT), counts=True),
    Step("package", "package", ("nice", "make", "package"), is_aside=True),
    marked_tests("waits", "test", *WAITING, only="waits", without="nightly"),
    marked_tests("fuzz", "test", *WORKING, "--fuzz-s=10", only="fuzz"),
    marked_tests("e2e", "test", *WORKING, only="e2e", without="nightly"),
    marked_tests("packaged", "package", only="packaged", without="nightly"),
    Step("smoke", "package", (sys.executable, "packaging/smoke.py")),
    marked_tests("nightly", "nightly", only="nightly"),
    marked_tests("late-e2e", "nightly", *WORKING, LATE, only="e2e", without="nightly", n_busy=2),
    marked_tests("long-fuzz", "nightly", "--fuzz-s=300", only="fuzz"),
    Step("bench", "nightly", ("make", "bench"), counts=True),
)


@dataclass
class StepResult:
    step: Step
    status: int
    seconds: float
    output: str

    @property
    def closing(self) -> str:
        """Returns the runner's summary line, or "" without one."""
        lines = _CLOSING.findall(self.output)
        return lines[-1].strip() if lines else ""

    @property
    def failed(self) -> bool:
        """True if the step failed; a runner that ran no test counts as failed."""
        return self.status != 0 or (self.step.counts and not _COUNT.search(self.closing))


def run_all(steps: Sequence[Step]) -> list[StepResult]:
    """Runs the steps in their order; steps that only read the code run in pairs, because most use one core."""
    reading = [step for step in steps if step.group == "lint"]
    with ThreadPoolExecutor(2) as pool:
        outcomes = list(pool.map(lambda step: run(step, is_live=False), reading))
        aside: dict[str, Future[StepResult]] = {}
        for step in (step for step in steps if step not in reading):
            if step.is_aside:
                aside[step.group] = pool.submit(run, step, is_live=False)
                continue
            if step.group in aside:
                outcomes.append(aside.pop(step.group).result())
            outcomes.append(run(step))
        return outcomes + [one.result() for one in aside.values()]


@contextmanager
def busy_loops(n: int) -> Iterator[None]:
    """Runs `n` processes that only use the processor."""
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(n)]
    try:
        yield
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()


def run(step: Step, *, is_live: bool = True) -> StepResult:
    """Runs one step; shows its output, live or at its end, and writes it to the log."""
    title = f"\n--- {step.name}: {' '.join(step.command[-4:])}"
    if is_live:
        print(title, flush=True)
    started = time.monotonic()
    lines = []
    with (
        busy_loops(step.n_busy),
        subprocess.Popen(
            step.command,
            cwd=ROOT,
            env=environment(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            encoding="utf-8",
            errors="replace",
        ) as process,
    ):
        assert process.stdout is not None
        for line in process.stdout:
            if is_live:
                print(line, end="", flush=True)
            lines.append(line)
    if not is_live:
        print(title, "".join(lines), sep="\n", end="", flush=True)
    output = _COLOURS.sub("", "".join(lines))
    (LOGS / f"{step.name}.log").write_text(output, "utf-8")
    return StepResult(step, process.returncode, time.monotonic() - started, output)


def totals(outcomes: Sequence[StepResult]) -> dict[str, int]:
    """Returns the tests passed, failed and skipped over all runners; an aborted step counts as one failure."""
    total = {"passed": 0, "failed": 0, "skipped": 0}
    for outcome in outcomes:
        before = total["failed"]
        if outcome.step.counts:
            for number, outcome_name in _COUNT.findall(outcome.closing):
                total[_SUM_OF[outcome_name]] += int(number)
        if outcome.failed and total["failed"] == before:
            total["failed"] += 1
    return total


def by_duration(outcomes: Sequence[StepResult]) -> list[tuple[float, str]]:
    """Returns seconds and names of the slowest tests of all pytest steps, the slowest first."""
    found = [hit for outcome in outcomes for hit in _DURATION.findall(outcome.output)]
    return sorted(((float(seconds), name) for seconds, name in found), reverse=True)[:N_DURATIONS]


def report(outcomes: Sequence[StepResult], seconds: float) -> None:
    """Prints the slowest tests, one line per step, then the totals; `seconds` is the duration of all steps."""
    print("\n--- slowest tests")
    for duration, name in by_duration(outcomes):
        print(f"{duration:6.1f} s  {name}")
    print("\n--- summary")
    for outcome in outcomes:
        mark = "FAILED" if outcome.failed else "ok"
        closing = outcome.closing.strip("= ")
        print(f"{outcome.step.name:<13} {outcome.seconds:6.1f} s  {mark:<7}{closing}".rstrip())
    print(f"{'together':<13} {seconds:6.1f} s")
    print(
        ", ".join(f"{number} {outcome_name}" for outcome_name, number in totals(outcomes).items()),
        flush=True,
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    names = sorted({step.group for step in STEPS} | {step.name for step in STEPS})
    parser.add_argument("--nightly", action="store_true", help="long tests and benchmarks too")
    parser.add_argument("--only", choices=names, help="one group or one step")
    options = parser.parse_args()
    steps = [step for step in STEPS if options.nightly or step.group != "nightly"]
    if options.only:
        steps = [step for step in STEPS if options.only in (step.group, step.name)]
    LOGS.mkdir(parents=True, exist_ok=True)
    started = time.monotonic()
    outcomes = run_all(steps)
    report(outcomes, time.monotonic() - started)
    return int(any(outcome.failed for outcome in outcomes))


if __name__ == "__main__":
    sys.exit(main())
