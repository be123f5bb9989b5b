"""PinelError: the base class of errors with a message for people."""


class PinelError(Exception):
    """A problem that a person can act on: a code of `messages/`, and parameters for its placeholders.

    Message and remedy are looked up where they are displayed, in the reader's language. `sim` and `storage` import
    nothing of `pinel_desktop`, so they raise errors of their own with the same two attributes.
    """

    def __init__(self, code: str, **params: object) -> None:
        super().__init__(f"{code} {params}" if params else code)
        self.code = code
        self.params: dict[str, object] = params
