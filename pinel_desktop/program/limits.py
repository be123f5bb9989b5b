"""Limits of a document (docs/program-document.md, Limits). Exceeding one is a fault, never a hang or a crash."""

MAX_BYTES = 1024 * 1024
MAX_COMMANDS = 20_000
MAX_NESTING = 64
MAX_TEXT = 10_000
MAX_LIST = 10_000
MAX_VARIABLES = 1_000
MAX_PARAMETERS = 100  # of a function
MAX_NAME = 64
MAX_RECURSION = 100
MAX_STEPS_PER_TICK = 1_000
MAX_RUN_S = 3600.0

MAX_DISTANCE_M = 100.0
MAX_ANGLE_DEG = 3600.0
MAX_WAIT_S = 600.0
MAX_REPEATS = 100_000
