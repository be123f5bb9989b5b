"""Deleting for good: here, where files are merged, and what waits for a decision."""
