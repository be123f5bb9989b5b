"""The real app as a separate process."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import psutil

from tests.e2e.delays import app_module, slower

_START_S = 30.0 * slower()


class AppProcess:
    """`pinel serve` on its own folder; the first line that it prints is the one-time address.

    Args:
        open_files: limit of files that the app may open; None is the limit of the test process.
    """

    def __init__(self, home: Path, *options: str, open_files: int | None = None) -> None:
        self._home, self._options, self._open_files = home, options, open_files
        self._process: subprocess.Popen[str] | None = None
        self.link = ""
        self.signed_in: Any = None  # cookie of the first browser context, for further contexts

    def start(self) -> str:
        """Starts the app; returns its one-time address."""
        log = (self._home / "serve.log").open("a", encoding="utf-8")
        with log:
            self._process = self._spawn(log.fileno())
        self.signed_in = None
        self.link = self._first_line(self._process)
        return self.link

    @property
    def origin(self) -> str:
        return self.link.split("?")[0]

    @property
    def pid(self) -> int:
        """Id of the running process."""
        assert self._process is not None
        return self._process.pid

    @property
    def database(self) -> Path:
        """The database file; access it only while the app is stopped."""
        return self._home / "pinel.db"

    def fresh_link(self) -> str:
        """Returns another one-time address of the running app, as a second start prints it."""
        second = self._spawn(subprocess.DEVNULL)
        try:
            link = self._first_line(second)
            second.wait(_START_S)
        finally:
            _end(second, signal.SIGKILL)
        return link

    def freeze_engine(self) -> None:
        """Suspends the engine's process, as a hang does."""
        for engine in self._engines():
            engine.suspend()

    def kill_engine(self) -> None:
        """Kills the engine's process, as a crash does."""
        for engine in self._engines():
            engine.kill()

    def kill(self) -> None:
        """Kills the process, as a power cut does."""
        self._stop(signal.SIGKILL)

    def stop(self) -> None:
        self._stop(signal.SIGTERM)

    def log(self) -> str:
        return (self._home / "serve.log").read_text("utf-8")

    def _engines(self) -> list[psutil.Process]:
        children = psutil.Process(self.pid).children()
        return [one for one in children if one.is_running() and one.cmdline()[-1:] == ["engine"]]

    def _stop(self, number: signal.Signals) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        try:
            _end(process, number)
        except subprocess.TimeoutExpired:
            _end(process, signal.SIGABRT)  # Python then prints the stack of each thread
            raise AssertionError(f"the app did not end:\n{self.log()}") from None

    def _spawn(self, errors: int) -> subprocess.Popen[str]:
        command = [sys.executable, *app_module(), "serve", *self._options]
        if self._open_files is not None:
            command = ["sh", "-c", f'ulimit -n {self._open_files}; exec "$@"', "sh", *command]
        return subprocess.Popen(
            command,
            env={
                **os.environ,
                "PINEL_HOME": str(self._home),
                "LANG": "pt_BR.UTF-8",
                "PYTHONFAULTHANDLER": "1",
            },
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=errors,
            text=True,
            encoding="utf-8",
        )

    def _first_line(self, process: subprocess.Popen[str]) -> str:
        assert process.stdout is not None
        line = process.stdout.readline().strip()
        assert line.startswith("http://127.0.0.1:"), f"no address but {line!r}: {self.log()}"
        return line


def _end(process: subprocess.Popen[str], number: signal.Signals) -> None:
    if process.poll() is None:
        process.send_signal(number)
    process.wait(_START_S)
    if process.stdout is not None:
        process.stdout.close()
