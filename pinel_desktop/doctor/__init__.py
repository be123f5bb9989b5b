"""What this PC has and lacks (`pinel doctor`)."""
