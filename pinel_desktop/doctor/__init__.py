"""The diagnosis of this PC (`pinel doctor`)."""
