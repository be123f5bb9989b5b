"""Checks of what a run leaves on the floor: boxes, marks, drawings."""
