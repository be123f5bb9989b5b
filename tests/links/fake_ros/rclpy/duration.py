class Duration:
    def __init__(self, *, nanoseconds):
        self.nanoseconds = nanoseconds
