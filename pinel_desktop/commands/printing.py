"""How commands tell a person what is wrong."""

from typing import IO, Any

import click

from pinel_desktop.messages import Problem, explain


class Failure(click.ClickException):
    """Ends a command with the words of a problem: what is wrong, and below it what to do."""

    def __init__(self, problem: Problem) -> None:
        words = explain(problem)
        super().__init__(f"{words.message}\n{words.remedy}")

    def show(self, file: IO[Any] | None = None) -> None:
        click.echo(self.message, file=file, err=file is None)


def print_problem(problem: Problem, language: str | None = None, *, place: str = "") -> None:
    """Says on standard error what is wrong and what to do, on one line after the place."""
    click.echo(f"{place}: " * bool(place) + explain(problem, language).line, err=True)
