"""Checks of the robot's path and end pose."""
