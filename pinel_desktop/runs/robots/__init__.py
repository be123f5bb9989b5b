"""Real robots outside of runs: heard while a page asks for it, moved by held keys, let go before a run."""

# Types of the messages of the app about a real robot; each has the robot's record.
WATCH, JOG, HALT, AT_START = "watch_robot", "jog_robot", "halt_robot", "robot_at_start"
ROBOT_MESSAGES = frozenset({WATCH, JOG, HALT, AT_START})

# A page asks every two seconds; one that does not ask any more has gone.
LEASE_S = 6.0

# Type of the message that tells how a robot is; its fields are those of `events.app_events.RobotStateTold`.
ROBOT_STATE = "robot_state"
