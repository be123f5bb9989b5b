"""Models about runs on real robots."""
