"""Several who have one file open at once: nothing of any of them is lost."""

import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

from storage import RunRecorder, RunStart, Store, open_store
from tests.storage.sample_runs import ended, sample

N_EDITS, N_RUNS, N_SAMPLES = 60, 8, 45
NEIGHBOUR = """
import sys
sys.path[:0] = {import_path!r}
from pathlib import Path
from tests.storage.file.test_neighbours import work
from storage import open_store
with open_store(Path(sys.argv[1])) as store:
    print("open", flush=True)
    sys.stdin.readline()
    work(store, sys.argv[2], sys.argv[3])
"""


def work(store: Store, program_id: str, who: str) -> None:
    """Edits a program and runs it, again and again."""
    recorder = RunRecorder(store)
    for n in range(N_EDITS):
        version = store.versions.save(program_id, {"who": who, "n": n}, None)
        if n % (N_EDITS // N_RUNS) == 0:
            start = RunStart("sim", who, {}, n, "1", version_id=version.id)
            run = store.runs.begin(start)
            for tick in range(N_SAMPLES):
                recorder(sample(run.id, tick))
            recorder(ended(run.id, N_SAMPLES, N_SAMPLES))
            recorder.flush().result()


def check_all_there(store: Store, program_id: str, *whos: str) -> None:
    marks = store.versions.history_of(program_id)
    assert sorted(mark.number for mark in marks) == list(range(1, len(whos) * N_EDITS + 1))
    for who in whos:
        texts = [store.versions.get(mark.id).workspace for mark in marks]
        mine = sorted(text["n"] for text in texts if text["who"] == who)
        assert mine == list(range(N_EDITS))
        runs = [run for run in store.runs.newest(1000) if run.world == who]
        assert len(runs) >= N_RUNS
        for run in runs:
            assert run.state == "finished"
            assert len(store.runs.telemetry(run.id).rows) == N_SAMPLES


def test_two_stores_that_write_at_once_lose_nothing(
    opened: Callable[..., Store], store: Store
) -> None:
    program = store.programs.create(store.groups.create("A").id, "P")
    others = [
        threading.Thread(target=work, args=(opened(), program.id, who)) for who in ("one", "two")
    ]
    for thread in others:
        thread.start()
    for thread in others:
        thread.join()
    check_all_there(store, program.id, "one", "two")


def test_two_programs_that_write_at_once_lose_nothing(path: Path) -> None:
    with open_store(path) as store:
        program = store.programs.create(store.groups.create("A").id, "P")
        script = NEIGHBOUR.format(import_path=[str(Path(__file__).parents[3]), *sys.path])
        with subprocess.Popen(
            [sys.executable, "-c", script, str(path), program.id, "two"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        ) as other:
            assert other.stdin is not None
            assert other.stdout is not None
            assert other.stdout.readline() == "open\n"
            other.stdin.write("go\n")
            other.stdin.flush()
            work(store, program.id, "one")
            assert other.wait(60) == 0
        check_all_there(store, program.id, "one", "two")
