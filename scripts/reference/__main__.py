"""Writes the files: `python -m scripts.reference`, run in the repository's root."""

from pathlib import Path

from scripts.reference.files import files

if __name__ == "__main__":
    for name, text in files(Path.cwd()).items():
        (Path.cwd() / name).write_text(text, "utf-8")
