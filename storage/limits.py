"""Limits of the values that a store writes. A bundle that exceeds one is refused, as no store wrote it.

Numbers that grow by one with each change stop at their limit. So a store with the largest number never writes a value
that another store would refuse.
"""

MAX_NUMBER = 10**9  # of a version within its program; MAX_NUMBERS_AHEAD is far less
# versions of a program are numbered from 1 and never deleted one by one: a number further above their count is forged
MAX_NUMBERS_AHEAD = 10_000
MAX_REVISION = 10**6  # a person makes each change; at the limit the later time decides
# decisions about one row, of which even ones delete. The limit is even, so that no forged file can retain for ever a
# row that a school must delete
MAX_TURN = 10_000
LAST_YEAR = 9998  # of a time; leaves a day for time zones at the end of the calendar
# for comparison: a run of an hour with the maximum of commands in each tick executes 1.08e8 commands
MAX_COUNT = 10**12
# bytes of one text or blob: a request body of 4 MiB, with each number and letter in its longest encoding
MAX_VALUE = 16 * 2**20
MAX_NAME = 60  # letters
MAX_NOTE = 1000  # letters
MAX_SIGN = 30  # letters of a taught sign's name
MAX_TAUGHT_SAMPLES = 20  # of one sign of a class: hands at rest, and as many movements
MAX_TAUGHT_SIGNS = 60  # of a class; it records no more, and more from merges do not count
# features of a hand, computed by gestures/features.py; a movement (gestures/moving/movements.py) has as many
N_FEATURES = 1748
MAX_OWN_ACTIVITIES = 200  # of a school, without deleted ones
MAX_CALIBRATED_ROBOTS = 50  # of a school, without deleted ones
MAX_ROBOT_PARAMETERS = 100  # of one robot
SAMPLES_PER_HOUR = 108_000
# of all runs in a file opened without PIN: unpacking them takes a second, and no program is run for so long
MAX_SAMPLES_WITHOUT_PIN = 36 * SAMPLES_PER_HOUR
MAX_TRUE_POSES = 60_000  # of a run by one source: more than an hour of a camera at 15 Hz
FARTHEST_M = 100.0  # of a true pose from the start, along each axis
MAX_SAMPLES = 200_000  # in a chunk of telemetry, and in a whole run; an hour has 108,000
