"""Models of requests and responses about results of runs."""
