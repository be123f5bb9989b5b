"""A run as one value: its inputs, its verification, its grading."""
