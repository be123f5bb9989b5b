"""Versions of the meaning of commands and sensors. A recorded run is repeated with the version of its record.

| version | since | change |
|---|---|---|
| 3 | before the first release | |
| 4 | 0.3 | `closing_error_m` is the true distance, null if unknown; the estimate is a field of its own |
"""

FIRST, CURRENT = 3, 4
TRUE_CLOSING_ERROR_SINCE = 4
