"""Repositories of runs: records, telemetry codec, history, grading results, confirmation."""
