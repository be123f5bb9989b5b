"""What the ROS 2 node sends to the app, and what it no longer does."""

import json
import subprocess
import sys

from pinel_desktop.links.ros2 import installed

PENDING_THEN_REMOVED = """
import time
from outbox import Outbox
outbox = Outbox()
outbox.put("battery", level=0.5)
time.sleep(0.3)
outbox.put("battery", level=0.4)  # pending for a second
outbox.drop("battery")
outbox.put("withdrawn", "battery", sensor="battery")
outbox.close()
"""


def test_a_pending_battery_level_is_not_sent_after_the_battery_was_removed() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PENDING_THEN_REMOVED],
        cwd=installed.NODE.parent,
        capture_output=True,
        check=True,
    )
    assert [json.loads(line) for line in done.stdout.splitlines()] == [
        {"type": "battery", "level": 0.5},
        {"type": "withdrawn", "sensor": "battery"},
    ]
