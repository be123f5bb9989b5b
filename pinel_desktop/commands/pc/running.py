"""Finds and ends the processes of the installed program, other than this one."""

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import psutil

_CLOSING_S = 10
_PERIOD_S = 0.1


def running(program: Path) -> list[psutil.Process]:
    """Returns the processes of a program, other than this process and those that started it."""
    psutil.process_iter.cache_clear()  # a process that it remembers may execute another program now
    own = {psutil.Process().pid, *(parent.pid for parent in psutil.Process().parents())}
    return [one for one in psutil.process_iter() if one.pid not in own and _is_of(one, program)]


def close(processes: list[psutil.Process]) -> list[psutil.Process]:
    """Ends processes in order, as the end of a session does; returns those that this account may not end."""
    pids = {one.pid for one in processes}
    for one in processes:
        if _parent(one) not in pids:  # it ends its own children
            _ask(one.terminate)
    for one in _wait(processes):
        _ask(one.kill)
    return _wait(processes)


def _is_of(process: psutil.Process, program: Path) -> bool:
    try:
        return process.exe() == str(program)
    except psutil.AccessDenied:  # of another account
        return _command(process) == str(program)
    except psutil.Error:
        return False


def _command(process: psutil.Process) -> str:
    try:
        return next(iter(process.cmdline()), "")
    except psutil.Error:
        return ""


def _wait(processes: list[psutil.Process]) -> list[psutil.Process]:
    """Waits for the end of processes; returns those that still run. One that its parent has not read yet has ended."""
    deadline = time.monotonic() + _CLOSING_S
    while (left := [one for one in processes if _is_running(one)]) and time.monotonic() < deadline:
        time.sleep(_PERIOD_S)
    return left


def _is_running(process: psutil.Process) -> bool:
    try:
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    except psutil.Error:
        return False


def _parent(process: psutil.Process) -> int | None:
    try:
        return process.ppid()
    except psutil.Error:
        return None


def _ask(end: Callable[[], None]) -> None:
    with suppress(psutil.Error):
        end()
