"""Services for lessons: grading, teacher's PIN, taught signs, robot profiles, removable drives, review of lessons."""
