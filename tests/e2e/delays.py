"""The switch `--delay-requests SEED`: each answer to the page is late, and the tests are more patient.

What a test looks at without waiting for it is then not there yet, so that the race shows.
"""

import os
from collections.abc import Sequence

SEED = "PINEL_TEST_DELAYS"  # in the environment, which the apps of the tests read too


def slower() -> int:
    """How many times longer than usual the tests wait for a thing."""
    return 3 if SEED in os.environ else 1


def app_module() -> Sequence[str]:
    """Which module Python starts as the app."""
    return ("-m", "tests.e2e.late_app" if SEED in os.environ else "pinel_desktop")
