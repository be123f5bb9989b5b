"""What a run reports: one frozen dataclass per event, and the hub that hands them on."""
