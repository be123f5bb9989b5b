"""Set-up of this PC by a file."""
