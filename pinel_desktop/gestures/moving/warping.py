"""Dynamic time warping: a distance between two sequences that does not depend on changes of pace within them.

Symmetric steps within a band about the diagonal. A diagonal step has double weight, and the sum is divided by the
length of both sequences. Source: Sakoe and Chiba, Dynamic programming algorithm optimization for spoken word
recognition, 1978.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BAND = 6  # frames


def dtw_distances(sequence: Array, others: Array, band: int = BAND) -> Array:
    """Returns the distances (m,) of a sequence (n, d) to m other sequences of the same length, (m, n, d)."""
    n = len(sequence)
    before = np.full((n + 1, len(others)), np.inf)
    before[0] = 0.0
    for i in range(n):
        first, last = max(0, i - band), min(n, i + band + 1)
        costs = np.sqrt(((others[:, first:last] - sequence[i]) ** 2).sum(2)).T
        now = np.full((n + 1, len(others)), np.inf)
        for cost, j in zip(costs, range(first, last), strict=True):
            aside = np.minimum(before[j + 1], now[j]) + cost
            now[j + 1] = np.minimum(before[j] + 2 * cost, aside)
        before = now
        before[0] = np.inf
    mean: Array = before[n] / (2 * n)
    return mean
