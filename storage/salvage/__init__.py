"""Salvage: recovers the readable rows of a damaged file and merges them into an intact one."""
