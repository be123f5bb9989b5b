"""Many runs of the same programs with other seeds: jobs, what runs them, and what they have in common."""

from pinel_desktop.sweep.executors import new_pool, rows_of, run_jobs
from pinel_desktop.sweep.gather import Reason, Summary, summary_of, together
from pinel_desktop.sweep.jobs import Job, make_jobs, run_job, worlds_of
from pinel_desktop.sweep.rows import Cause, Row

__all__ = [
    "Cause",
    "Job",
    "Reason",
    "Row",
    "Summary",
    "make_jobs",
    "new_pool",
    "rows_of",
    "run_job",
    "run_jobs",
    "summary_of",
    "together",
    "worlds_of",
]
