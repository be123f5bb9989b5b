"""Checks of where the robot goes."""
