import gc
import os

import pytest

from tests.e2e.delays import SEED


def pytest_configure(config: pytest.Config) -> None:
    """Beside other tests NumPy has one thread: more of them wait for each other, and keep the cores busy with it."""
    if hasattr(config, "workerinput"):
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    if seed := config.getoption("--delay-requests"):
        os.environ[SEED] = seed


def pytest_collection() -> None:
    gc.disable()


def pytest_collection_finish() -> None:
    """Keeps the garbage collector from reading all tests again and again: they stay until the end."""
    gc.enable()
    gc.freeze()


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    if seed := os.environ.get(SEED):
        terminalreporter.write_line(f"requests of the page were delayed: --delay-requests={seed}")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--pictures", help="folder for pictures of the lesson of two hours")
    parser.addoption(
        "--fuzz-s", type=float, default=5.0, help="how long each test marked fuzz goes on, in s"
    )
    parser.addoption(
        "--delay-requests",
        metavar="SEED",
        help="each request of the page takes 200 to 600 ms longer, at random from this seed",
    )


@pytest.fixture
def fuzz_s(request: pytest.FixtureRequest) -> float:
    """Duration of each fuzzing test, in s."""
    return float(request.config.getoption("--fuzz-s"))
