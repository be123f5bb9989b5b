"""What commands and sensors mean, by version. A recorded run is repeated with the version that it ran with.

| version | since | what changed |
|---|---|---|
| 3 | before the first release | |
| 4 | 0.3 | `closing_error_m` is the true distance, null where nobody knows it; the estimate has a name of its own |
"""

FIRST, CURRENT = 3, 4
TRUE_CLOSING_ERROR_SINCE = 4
