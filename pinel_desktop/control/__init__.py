"""Motion profile, tracking controller, goal check, angles. PURE: no IO, thread or clock."""
