"""Breakpoints, steps, inspection of a paused run, and what observers see of a run."""
