"""The SQLite file: connection, writer thread, opening, backups, integrity check."""
