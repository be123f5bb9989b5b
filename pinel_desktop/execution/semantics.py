"""What commands and sensors mean, by version. A recorded run is repeated with the version that it ran with.

| version | since | what changed |
|---|---|---|
| 1 | 0.1 | |
| 2 | 0.2 | a straight motion that slides away along an obstacle is blocked; `distance` omits side walls ahead, behind |
| 3 | 0.2 | `path_length_m` is that of the true way where that is known; noise of measured poses no longer counts |
| 4 | 0.2 | `closing_error_m` is the true distance, null where nobody knows it; the estimate has a name of its own |
"""

FIRST, CURRENT = 1, 4
BLOCKS_SLIDING = 2
LOOKS_ALONG_THE_WAY = 2
MEASURES_THE_TRUE_WAY = 3
MEASURES_THE_TRUE_END = 4
