"""The local HTTP server: guard, event stream, API, page."""
