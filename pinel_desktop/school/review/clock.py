"""Times of a PC's clock as numbers, and how long nothing may happen before it counts as a pause."""

from datetime import datetime

# who does nothing for longer is talking, thinking or away: nobody can tell
PAUSE_S = 300.0
# who does nothing for longer has left the room: a break, the end of a day
AWAY_S = 3600.0


def seconds_of(time: str) -> float:
    """Seconds of a clock; a time that is none, in a file of somebody else's, is the beginning of all times."""
    try:
        return datetime.fromisoformat(time).timestamp()
    except (ValueError, OverflowError):
        return 0.0
