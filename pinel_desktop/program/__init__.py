"""The program document (docs/program-document.md): model, reading, faults. PURE: no IO, thread or clock."""
