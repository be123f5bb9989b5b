"""How long an edit takes to be on disk while a file of 300 MB is being backed up."""

import os
import statistics
import threading
import time
from datetime import UTC, datetime
from pathlib import Path

from storage import Store, open_store
from storage.file.backups import make_backup

N_LARGE, LARGE_BYTES = 300, 500_000
N_ALONE = 100
PAUSE_S = 0.02
MAX_MS = 1000.0  # an edit is on disk within a second


def edit_ms(store: Store, program_id: str) -> float:
    start = time.perf_counter()
    store.versions.save(program_id, {"at": start}, None)
    took = time.perf_counter() - start
    time.sleep(PAUSE_S)
    return took * 1e3


def test_an_edit_is_on_disk_within_a_second_while_a_large_file_is_backed_up(tmp_path: Path) -> None:
    path = tmp_path / "pinel.db"
    with open_store(path) as store:
        program = store.programs.create(store.groups.create("A").id, "P")
        for _ in range(N_LARGE):
            store.versions.save(program.id, {"noise": os.urandom(LARGE_BYTES).hex()}, None)
        alone = [edit_ms(store, program.id) for _ in range(N_ALONE)]
        start_s = time.perf_counter()
        backup = threading.Thread(target=make_backup, args=(path, datetime.now(UTC)))
        backup.start()
        during = []
        while backup.is_alive():
            during.append(edit_ms(store, program.id))
        took_s = time.perf_counter() - start_s
    print(
        f"\nbackup of {path.stat().st_size / 1e6:.0f} MB in {took_s:.1f} s; an edit alone "
        f"{statistics.median(alone):.1f} ms (longest {max(alone):.0f}), meanwhile "
        f"{statistics.median(during):.1f} ms (longest {max(during):.0f})"
    )
    assert max(during) <= MAX_MS
