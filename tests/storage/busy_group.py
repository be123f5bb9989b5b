"""A group that saves and runs without end, and says what was kept; killed by test_kill.py."""

import json
import sys
from itertools import count
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

from storage import Recorder, RunStart, open_store
from tests.storage.sample_runs import ended, sample


def say(kept: str, row_id: str, text: str = "") -> None:
    print(json.dumps({"kept": kept, "id": row_id, "text": text}), flush=True)


def main(path: Path) -> None:
    with open_store(path, close_interrupted=True) as store:
        groups = store.groups.all()
        group = groups[0] if groups else store.groups.create("A")
        program = store.programs.create(group.id, "P")
        recorder = Recorder(store)
        for n in count():
            text = f"{n} " + "x" * (n * 997 % 9000)
            version = store.versions.save(program.id, {"text": text}, {"pinel_ir": 1})
            say("version", version.id, text)
            run = store.runs.begin(
                RunStart(
                    link="sim",
                    world="w",
                    world_document={},
                    seed=0,
                    app_version="1",
                    version_id=version.id,
                )
            )
            say("run", run.id)
            for tick in range(40):
                recorder(sample(run.id, tick))
            recorder(ended(run.id, 40, 40))
            say("end of run", run.id)


main(Path(sys.argv[1]))
