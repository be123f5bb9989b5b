"""Generates the committed files derived from declarations: JSON Schemas, parts of docs/, sensor rows of the page.

`python -m scripts.reference`, run in the repository's root, writes all of them. `tests/scripts/test_reference.py` fails
if they are outdated.
"""
