"""Events of runs and of the app: one frozen dataclass per event, and the hub that publishes them."""
