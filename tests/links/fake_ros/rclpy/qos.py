class HistoryPolicy:
    KEEP_LAST = "keep_last"


class ReliabilityPolicy:
    RELIABLE = "reliable"
    BEST_EFFORT = "best_effort"


class QoSProfile:
    def __init__(self, *, depth, history, reliability):
        self.depth, self.history, self.reliability = depth, history, reliability
