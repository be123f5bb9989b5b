"""Accounts of one PC, which only root can play, and the calls of a home folder on a server that refuses locks."""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.web.browser import Browser

_ROOT = Path(__file__).parents[2]
_TIMEOUT_S = 100
ANA, BIA, CLASS = 61_001, 61_002, 61_100
# as NFS without its lock service
_NO_LOCKS = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>

static int is_lock(int command) {
    return command == F_SETLK || command == F_SETLKW || command == F_GETLK || command == F_OFD_SETLK ||
           command == F_OFD_SETLKW || command == F_OFD_GETLK;
}

int flock(int file, int operation) { errno = ENOLCK; return -1; }

#define FCNTL(name)                                                        \
    int name(int file, int command, ...) {                                 \
        va_list rest;                                                      \
        va_start(rest, command);                                           \
        void *argument = va_arg(rest, void *);                             \
        va_end(rest);                                                      \
        if (is_lock(command)) { errno = ENOLCK; return -1; }               \
        int (*real)(int, int, ...) = dlsym(RTLD_NEXT, #name);              \
        return real(file, command, argument);                              \
    }
FCNTL(fcntl)
FCNTL(fcntl64)
"""


@dataclass
class Session:
    """`pinel serve` in an account; `browser` has opened its page, or is None if it has ended."""

    browser: Browser | None
    process: "subprocess.Popen[str]"
    output: str

    @property
    def groups(self) -> list[str]:
        assert self.browser is not None, self.output
        return [group["name"] for group in self.browser.get("/api/groups").data["groups"]]

    @property
    def notice(self) -> str | None:
        """The code of what it says of its file."""
        assert self.browser is not None, self.output
        found = self.browser.get("/api/status").data["database"]["notice"]
        return found and str(found["code"])

    def create(self, name: str) -> int:
        assert self.browser is not None, self.output
        return self.browser.post("/api/groups", {"name": name}).status


@contextmanager
def session(account: int, home: Path, umask: int = 0o022, **environment: str) -> Iterator[Session]:
    """PINEL in an account; skips where this user may not play others."""
    if os.geteuid():
        pytest.skip("only root can play other accounts")
    with tempfile.TemporaryFile("w+", encoding="utf-8") as errors:
        process = subprocess.Popen(
            [sys.executable, "-m", "pinel_desktop", "serve"],
            cwd=_ROOT,
            env={"HOME": str(home), "PINEL_LANG": "en", "PATH": os.defpath, **environment},
            stdout=subprocess.PIPE,
            stderr=errors,
            text=True,
            user=account,
            group=account,
            extra_groups=[CLASS],
            umask=umask,
        )
        assert process.stdout is not None
        address = re.match(r"http://127\S+", process.stdout.readline())
        if not address:
            process.wait(_TIMEOUT_S)
        errors.seek(0)
        browser = Browser.signed_in(address[0]) if address else None
        try:
            yield Session(browser, process, errors.read())
        finally:
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=_TIMEOUT_S)
            errors.seek(0)
            assert "Traceback" not in errors.read()


@contextmanager
def homes() -> Iterator[Path]:
    """A folder that all accounts can enter, which pytest's own is not."""
    folder = Path(tempfile.mkdtemp(prefix="pinel-homes-"))
    folder.chmod(0o755)
    try:
        yield folder
    finally:
        shutil.rmtree(folder)


def make_home(folder: Path, account: int, mode: int = 0o700) -> Path:
    folder.mkdir(mode)
    folder.chmod(mode)
    os.chown(folder, account, account)
    return folder


def library_without_locks(folder: Path) -> Path:
    """Builds a library to preload in which no lock is granted; skips without a compiler."""
    source, library = folder / "no_locks.c", folder / "no_locks.so"
    source.write_text(_NO_LOCKS, "utf-8")
    if shutil.which("cc") is None:
        pytest.skip("no compiler of C")
    command = ["cc", "-shared", "-fPIC", "-o", str(library), str(source), "-ldl"]
    subprocess.run(command, check=True, capture_output=True)
    return library
