class HistoryPolicy:
    KEEP_LAST = "keep_last"


class ReliabilityPolicy:
    RELIABLE = "reliable"
    BEST_EFFORT = "best_effort"


class DurabilityPolicy:
    VOLATILE = "volatile"
    TRANSIENT_LOCAL = "transient_local"


class QoSProfile:
    def __init__(
        self,
        *,
        depth,
        history,
        reliability,
        durability=DurabilityPolicy.VOLATILE,
        lifespan=None,
    ):
        self.depth, self.history, self.reliability = depth, history, reliability
        self.durability, self.lifespan = durability, lifespan
