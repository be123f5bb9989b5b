"""Subcommands that the app starts as processes of its own (`processes/supervisor.py`); people do not call them."""
