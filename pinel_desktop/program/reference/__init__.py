"""What is made from the models of the language: tables of the docs, JSON Schema, rows for the page's blocks.

`python -m pinel_desktop.program.reference`, from the repository's root, writes all files; a test holds them current.
"""
