"""Prints problems for people."""

from typing import IO, Any

import click

from pinel_desktop.messages import Problem, explain


class Failure(click.ClickException):
    """Ends a command with the message of a problem and, on the next line, its remedy."""

    def __init__(self, problem: Problem) -> None:
        words = explain(problem)
        super().__init__(f"{words.message}\n{words.remedy}")

    def show(self, file: IO[Any] | None = None) -> None:
        click.echo(self.message, file=file, err=file is None)


def print_problem(problem: Problem, language: str | None = None, *, place: str = "") -> None:
    """Prints `place`, message and remedy of a problem on one line of standard error."""
    click.echo(f"{place}: " * bool(place) + explain(problem, language).line, err=True)
