"""Checks of the traces that a run leaves on the floor: boxes, marks, drawings."""
