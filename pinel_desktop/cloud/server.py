"""The process of the clouds: requests in, rows out. Its own processes drive the robots, and are warm before."""

import contextlib
import logging
import os
import threading
from collections.abc import Iterator
from typing import Any, BinaryIO

import psutil

from pinel_desktop.activities import Activity
from pinel_desktop.cloud.messages import N_ROBOTS, STOP, CloudRequest
from pinel_desktop.cloud.sentence import sentence_of
from pinel_desktop.processes.messages import PING, PONG, Message, read_messages, write_message
from pinel_desktop.sweep import Job, Row, make_jobs, new_pool, rows_of, summary_of, together

_log = logging.getLogger(__name__)
_MAX_WORKERS = 4
_BYTES_EACH = 300 * 2**20  # free memory for each process beyond the first
_LIMIT_S = 180.0  # robot time, without an activity
_N_POSES = 60
_BELOW_NORMAL = 0x4000  # of Windows


def n_workers() -> int:
    """Returns how many processes this PC affords: one per core, fewer where cores or memory are short."""
    n_affordable = psutil.virtual_memory().available // _BYTES_EACH
    return max(1, min(_MAX_WORKERS, os.cpu_count() or 1, n_affordable))


def _priority() -> int:
    """Returns a lower priority: the page and a live run come first."""
    return 5 if os.name == "posix" else _BELOW_NORMAL


def jobs_of(request: CloudRequest) -> Iterator[Job]:
    """Yields the jobs of a cloud, one for each robot. Raises what `make_jobs` raises."""
    activity = Activity.model_validate_json(request.activity) if request.activity else None
    return make_jobs(
        [("", request.document)],
        [("", request.world)],
        request.setting,
        range(1, N_ROBOTS + 1),
        inputs=request.inputs,
        activity=activity,
        limit_s=None if activity else _LIMIT_S,
        n_poses=_N_POSES,
    )


class CloudServer:
    """Answers requests and probes; runs one cloud at a time, on a thread. A newer request ends the older cloud.

    Args:
        requests: pipe of requests.
        rows: pipe of rows and sentences.
    """

    def __init__(self, requests: BinaryIO, rows: BinaryIO) -> None:
        self._requests, self._rows = requests, rows
        self._writing = threading.Lock()
        self._pool = new_pool(n_workers())
        self._runner: threading.Thread | None = None

    def serve(self) -> None:
        """Serves until the input pipe ends."""
        with contextlib.suppress(psutil.Error, OSError):
            psutil.Process().nice(_priority())
        self._pool.start()
        self._write({"type": "cloud_ready"})
        for message in read_messages(self._requests):
            if message == PING:
                self._write(PONG)
                continue
            self._end_runner()
            if message["type"] != STOP:
                request = CloudRequest.from_message(message)
                self._runner = threading.Thread(target=self._run, args=(request,), name="cloud")
                self._runner.start()
        self._end_runner()
        self._pool.end()

    def _end_runner(self) -> None:
        if self._runner is not None:
            self._pool.cancel()
            self._runner.join()
            self._runner = None
        self._pool.start()  # warm again for the next cloud

    def _run(self, request: CloudRequest) -> None:
        rows: list[Row] = []
        error = None
        try:
            for row in rows_of(self._pool, jobs_of(request)):
                rows.append(row)
                self._write(_message(request, rows=[_plain(row)]))
        except Exception as problem:
            # whatever one program does, the next cloud must be possible
            _log.exception("a cloud has ended")
            error = f"{type(problem).__name__}: {problem}"
        self._write(_message(request, rows=[], end=_end(request, rows), error=error))

    def _write(self, message: Message) -> None:
        with self._writing:
            write_message(self._rows, message)


def _message(request: CloudRequest, **parts: Any) -> Message:
    return {"type": "cloud", "cloud": request.cloud, "end": None, "error": None, **parts}


def _plain(row: Row) -> dict[str, Any]:
    """Returns what the page draws of a robot."""
    path = [*row.path, row.end[:2]] if row.end else []
    return {"seed": row.seed, "well": row.is_well, "cause": row.cause, "path": path}


def _end(request: CloudRequest, rows: list[Row]) -> dict[str, Any]:
    summary, is_judged = summary_of(rows), request.activity is not None
    text = sentence_of(
        summary, request.document, request.language, is_judged=is_judged, case=request.case
    )
    block = next((reason.block for reason, _ in summary.reasons if reason.block), None)
    good = [row for row in rows if row.is_well] if is_judged else together(rows)
    return {"good": [row.seed for row in good], "text": text, "block": block}
