"""Migrations, views, and the generated description of the tables."""
