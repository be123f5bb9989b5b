"""What belongs to the school: the teacher's PIN, removable drives, names of bundle files, the review of a lesson."""
