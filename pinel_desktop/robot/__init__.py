"""Pose, twist, state, the RobotLink protocol and robot records. PURE: no IO, thread or clock."""
