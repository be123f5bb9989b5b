"""Writes the files: `python -m pinel_desktop.program.reference`, from the repository's root."""

from pathlib import Path

from pinel_desktop.program.reference.files import files

if __name__ == "__main__":
    for name, text in files(Path.cwd()).items():
        (Path.cwd() / name).write_text(text, "utf-8")
