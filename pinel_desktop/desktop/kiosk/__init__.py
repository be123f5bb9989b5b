"""Kiosk mode: the window fills the screen, only the teacher can close it, and it opens again after a crash."""
