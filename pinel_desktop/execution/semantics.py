"""What commands and sensors mean, by version. A recorded run is repeated with the version that it ran with.

| version | since | what changed |
|---|---|---|
| 1 | 0.1 | |
| 2 | 0.2 | a straight motion that slides away along an obstacle is blocked; `distance` omits side walls ahead, behind |
"""

FIRST, CURRENT = 1, 2
BLOCKS_SLIDING = 2
LOOKS_ALONG_THE_WAY = 2
