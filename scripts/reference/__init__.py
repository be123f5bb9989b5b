"""The committed files that are made from the code's declarations: JSON Schemas, parts of docs/, rows for the page.

`python -m scripts.reference`, from the repository's root, writes all of them; `tests/scripts/test_reference.py` holds
them current.
"""
