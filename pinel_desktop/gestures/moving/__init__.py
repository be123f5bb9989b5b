"""Signs that move: movements in a video, and their comparison with the examples of a class."""
