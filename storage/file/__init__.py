"""The SQLite file: opening, connections, writer thread, backups, checksums, integrity check, repair."""
