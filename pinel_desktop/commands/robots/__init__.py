"""Real robots: the options of their links, and their calibration."""
