"""The SQLite store: groups, programs, versions, runs, events, telemetry. A leaf package."""
