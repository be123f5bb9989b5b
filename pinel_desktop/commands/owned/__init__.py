"""Subcommands that the app starts as processes of its own (`processes/owned.py`); people do not call them."""
