"""Checks of a run as a whole."""
