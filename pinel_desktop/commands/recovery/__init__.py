"""Commands for damaged files."""
