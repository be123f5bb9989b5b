"""Commands for files that were damaged."""
