"""The one error that a person is meant to read."""


class PinelError(Exception):
    """Something a person can act on: a code of `messages/` and what fills its placeholders.

    The words (message and remedy) are looked up where they are shown, in the reader's language. `sim` and
    `storage` are leaves and raise errors of their own with the same two attributes.
    """

    def __init__(self, code: str, **params: object) -> None:
        super().__init__(f"{code} {params}" if params else code)
        self.code = code
        self.params: dict[str, object] = params
