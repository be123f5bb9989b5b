"""Clock times as numbers, and the limits beyond which inactivity counts as a pause."""

from datetime import datetime

# longer inactivity ends a burst of edits and does not count as active time
PAUSE_S = 300.0
# longer inactivity means that the group was away: a break, the end of a day
AWAY_S = 3600.0


def seconds_of(time: str) -> float:
    """ISO 8601 text as seconds since the epoch; 0 for invalid text, which a merged file may hold."""
    try:
        return datetime.fromisoformat(time).timestamp()
    except (ValueError, OverflowError):
        return 0.0
