"""Breakpoints, steps, inspection of a paused run, and reports to observers."""
