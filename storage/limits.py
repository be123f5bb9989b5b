"""Limits of what a store writes. A bundle that exceeds one is refused, as no store wrote it.

Numbers that grow by one with each change stop at their limit, so that a store with the largest number never writes what
another store would refuse.
"""

MAX_NUMBER = 10**9  # of a version within its program; MAX_NUMBERS_AHEAD is far less
# versions of a program are counted from 1 on, none is ever taken out: a number so far beyond their count was made up
MAX_NUMBERS_AHEAD = 10_000
MAX_REVISION = 10**6  # a person changes a row; at the limit the later time decides
# decisions about one row, of which even ones delete: the last is a deletion, so that no made-up file keeps for ever
# what a school must delete
MAX_TURN = 10_000
LAST_YEAR = 9998  # of a time: a day to spare at the end of the calendar for zones of time
# a run of an hour at the most commands a tick has 1.08e8
MAX_COUNT = 10**12
# bytes of one text or blob: of a body of 4 MiB, with each number and letter written at its longest
MAX_VALUE = 16 * 2**20
MAX_NAME = 60  # letters
MAX_NOTE = 1000  # letters
MAX_SIGN = 30  # letters of a taught sign's name
MAX_TAUGHT_SAMPLES = 20  # of one sign of a class: hands at rest, and as many movements
MAX_TAUGHT_SIGNS = 60  # of a class that count; it does not record more
# of a hand, as the application's gestures/features.py computes them; a movement (gestures/movements.py) has as many
N_FEATURES = 1748
MAX_OWN_ACTIVITIES = 200  # of a school that can be chosen
SAMPLES_PER_HOUR = 108_000
# of all runs of a file that is opened without PIN: unpacking them takes a second, and nobody runs one program so long
MAX_SAMPLES_WITHOUT_PIN = 36 * SAMPLES_PER_HOUR
MAX_SAMPLES = 200_000  # in a chunk of telemetry, and in all of a run: an hour has 108,000
