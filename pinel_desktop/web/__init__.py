"""The HTTP interface: page, API and event stream. `app` injects its dependencies as `Services`.

Import from its modules, not from here: `early_server` serves the page with light modules (`page`, `guard`, `server`)
while `application`, which is heavy, is still being imported.
"""
