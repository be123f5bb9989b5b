"""Bundles where they lie: on sticks that can only be read, beside files of others, closed to whoever asks."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from storage import Store
from tests.storage.bundle_makers import merged


def test_a_log_beside_it_is_not_believed(bundle: Path, store: Store, tmp_path: Path) -> None:
    for name in ("-journal", "-wal", "-shm"):
        bundle.with_name(bundle.name + name).write_bytes(os.urandom(4096))
    assert merged(store, bundle).added["runs"] == 2
    assert len(list(tmp_path.glob("there.pinel*"))) == 4


def test_a_stick_that_can_only_be_read_is_read(bundle: Path, store: Store) -> None:
    folder = bundle.parent / "stick"
    folder.mkdir()
    there = bundle.rename(folder / bundle.name)
    there.chmod(0o444)
    folder.chmod(0o555)
    try:
        assert merged(store, there).added["runs"] == 2
        assert [file.name for file in folder.iterdir()] == [there.name]
    finally:
        folder.chmod(0o755)


MAY_NOT_READ = """
import os, sys
from pathlib import Path
sys.path[:0] = {import_path!r}
from storage import StoreError
from storage.exchange.bundle_reading import open_bundle
if os.geteuid() == 0:  # who may read everything
    os.setgroups([]); os.setgid(65534); os.setuid(65534)
try:
    with open_bundle(Path(sys.argv[1])):
        print("read")
except StoreError as error:
    print(error.code)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
def test_a_file_that_may_not_be_read_is_told(bundle: Path) -> None:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        there = Path(shutil.copy(bundle, folder))
        there.chmod(0)
        result = subprocess.run(
            [sys.executable, "-c", MAY_NOT_READ.format(import_path=sys.path), str(there)],
            capture_output=True,
            text=True,
            check=False,
        )
    assert (result.stdout.strip(), result.stderr) == ("bundle_unreadable", "")
