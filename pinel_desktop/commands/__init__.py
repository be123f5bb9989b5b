"""The subcommands of `pinel`, one module each, exposing `command`."""
