"""Random programs run alike from their document, from Python text, and from blocks through the page's own generator."""

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, settings

from pinel_desktop.execution.executor import RunOptions, RunResult, execute
from pinel_desktop.links import open_link
from pinel_desktop.program.python_text import read_python, write_python
from pinel_desktop.program.reading import ParseResult, read_document
from tests.strategies import programs

ROOT = Path(__file__).parents[2]
N_PROGRAMS = 60
_NPX = 'PATH="$(sh scripts/node.sh):$PATH" && cd ui && exec npx vitest run src/blocks/loader/exchange.test.ts'

pytestmark = pytest.mark.timeout(300)


def drawn(count: int) -> list[dict[str, Any]]:
    """Documents in their normal form, all of them valid."""
    found: list[dict[str, Any]] = []

    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(programs())
    def draw(document: dict[str, Any]) -> None:
        normal = read_document(document).document
        assert normal is not None
        found.append(normal)

    draw()
    return found


@pytest.fixture(scope="module")
def documents() -> list[dict[str, Any]]:
    return drawn(N_PROGRAMS)


def run(reading: ParseResult) -> RunResult:
    assert reading.program is not None
    return execute(reading.program, open_link("sim", world="tic_tac_toe"), RunOptions(seed=7))


def outcome(result: RunResult) -> tuple[Any, ...]:
    """The exact results of a run, without the block of a failure."""
    ended = result.ended
    return (
        ended.state,
        ended.reason,
        ended.n_executed,
        ended.pose,
        ended.telemetry_sha256,
        result.shown_texts,
        result.variables,
    )


def test_python_text_runs_as_its_document_does(documents: list[dict[str, Any]]) -> None:
    for document in documents:
        text = write_python(document).text
        expected = outcome(run(read_document(document)))
        assert repr(outcome(run(read_python(text).result))) == repr(expected), text


def test_blocks_run_as_their_document_does(documents: list[dict[str, Any]], tmp_path: Path) -> None:
    file = tmp_path / "documents.json"
    file.write_text(json.dumps(documents), "utf-8")
    environment = os.environ | {"PINEL_EXCHANGE": str(file)}
    subprocess.run(["sh", "-c", _NPX], cwd=ROOT, env=environment, check=True, capture_output=True)
    made = json.loads(Path(f"{file}.out").read_text("utf-8"))
    assert len(made) == len(documents)
    for document, through_blocks in zip(documents, made, strict=True):
        expected = outcome(run(read_document(document)))
        assert repr(outcome(run(read_document(through_blocks)))) == repr(expected), document
