"""How a command that cannot go on says why."""

from typing import IO, Any

import click

from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from storage import StoreError


class Failure(click.ClickException):
    """An error in the words of the language: what is wrong, and below it what to do."""

    def __init__(self, error: PinelError | StoreError) -> None:
        words = describe(error.code, error.params, language_of_system())
        super().__init__(f"{words.message}\n{words.remedy}")

    def show(self, file: IO[Any] | None = None) -> None:
        click.echo(self.message, file=file, err=file is None)
