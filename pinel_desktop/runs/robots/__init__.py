"""Real robots between runs: monitoring while a page requests it, jogging by keys, and reservation for a run."""

# Types of the app's messages about a real robot; each message carries the robot's profile.
WATCH, JOG, HALT, AT_START = "watch_robot", "jog_robot", "halt_robot", "robot_at_start"
ROBOT_MESSAGES = frozenset({WATCH, JOG, HALT, AT_START})

# A page renews its lease every 2 s; a page that no longer does so was closed.
LEASE_S = 6.0

# Type of the message with a pose of the robot's own localisation during a run.
LOCALISED = "robot_localised"

# Type of the state message; `events.app_events.RobotStateChanged` declares its fields.
ROBOT_STATE = "robot_state"
