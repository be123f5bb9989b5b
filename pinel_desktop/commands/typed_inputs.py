"""Options for what a program reads without a person: signs and answers, in their order."""

import csv
from collections.abc import Callable, Sequence
from typing import Any

import click

_gestures = click.option(
    "--gestures", metavar="B,A,...", default="", help="Results of captures, in order."
)
_answers = click.option(
    "--answers",
    metavar="3,Ana,...",
    multiple=True,
    help="Answers to questions, in order; quote an answer with a comma: '3,\"1,5\"'.",
)


def input_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Adds the options."""
    return _gestures(_answers(command))


def typed_gestures(text: str) -> list[str]:
    """Returns the results of captures in order."""
    return [part.strip() for part in text.split(",")] if text else []


def typed_answers(texts: Sequence[str]) -> list[str]:
    """Returns the answers in order; each text is a CSV row, or one answer if it is not valid CSV."""
    found: list[str] = []
    for text in texts:
        try:
            found += next(csv.reader([text], skipinitialspace=True), [""])
        except csv.Error:  # the text contains line breaks
            found.append(text)
    return found
