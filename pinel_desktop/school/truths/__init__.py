"""Sources of truth that follow a live run of a real robot, and what they say is kept with it."""
