"""The program document of IR.md: model, reading, faults. PURE: no IO, thread or clock."""
