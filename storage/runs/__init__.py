"""Runs: reading, telemetry codec, history, grading results."""
