"""The HTTP interface: page, API and event stream. Its dependencies are injected by `app` as `Services`.

Import from its modules, not from here: `early_server` serves the page with the light ones (`page`, `guard`, `server`)
while `application`, which is heavy, is still being imported.
"""
