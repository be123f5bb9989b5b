"""Deletion for good: in this store, by a merge, and the deletions that wait for a decision."""
