"""Runs a program on a link, tick by tick, on an injected clock."""
