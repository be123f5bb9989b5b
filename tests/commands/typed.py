"""Runs commands as typed on the command line."""

import json
from pathlib import Path
from typing import Any

from click.testing import CliRunner, Result

from pinel_desktop.cli import main

PROGRAMS = Path(__file__).parents[1] / "programs"
SQUARE = str(PROGRAMS / "square.json")


def pinel(*arguments: str, text: str | None = None) -> Result:
    result = CliRunner().invoke(main, list(arguments), input=text)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


def run_json(*arguments: str, text: str | None = None) -> tuple[int, dict[str, Any]]:
    result = pinel("run", *arguments, "--json", text=text)
    return result.exit_code, json.loads(result.stdout)
