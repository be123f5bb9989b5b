"""Error codes of the store."""

from collections.abc import Callable

import pytest

from storage import StoreError


def code_of(attempt: Callable[[], object]) -> str:
    """The code of the error that the attempt raises."""
    with pytest.raises(StoreError) as caught:
        attempt()
    return caught.value.code
