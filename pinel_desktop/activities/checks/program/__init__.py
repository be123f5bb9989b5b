"""Checks of the program's commands."""
