"""Commands about real robots."""
