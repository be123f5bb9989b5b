"""Resources of the API about runs on real robots."""
