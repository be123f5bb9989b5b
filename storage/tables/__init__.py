"""Table declarations, validation rules, migrations and views."""
