"""The option `--delay-requests SEED`: delays each response to the page, and lengthens the tests' time limits.

If a test reads an element without waiting for it, the element does not exist yet. So the test shows its race condition.
"""

import os
from collections.abc import Sequence

SEED = "PINEL_TEST_DELAYS"  # environment variable, which the apps of the tests read too


def slower() -> int:
    """Returns the factor of the tests' time limits."""
    return 3 if SEED in os.environ else 1


def app_module() -> Sequence[str]:
    """Returns the arguments of Python for the module that it starts as the app."""
    return ("-m", "tests.e2e.late_app" if SEED in os.environ else "pinel_desktop")
