"""Requests about the app's window."""
