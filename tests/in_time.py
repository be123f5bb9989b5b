"""Bounds on time that say something on a quiet PC and do not fail on a busy one."""

import time
from collections.abc import Callable

_WORK_S = 0.05


def slowness() -> float:
    """How many times longer work of the processor takes now than on a PC that does nothing else."""
    start_s, worked_s = time.perf_counter(), time.thread_time()
    while time.thread_time() - worked_s < _WORK_S:
        pass
    return max(1.0, (time.perf_counter() - start_s) / _WORK_S)


def in_time(took_s: float, bound_s: float, slowness: Callable[[], float] = slowness) -> bool:
    """Whether what took so long would have kept the bound on a quiet PC; only who is late asks how busy this one is."""
    return took_s < bound_s or took_s < bound_s * slowness()
