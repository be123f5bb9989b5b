"""The HTTP interface: page, API and event stream. Gets all it works with from `app` as `Services`.

Import what you need from its modules: `page`, `guard` and `server` are light, `application` is not, and the page is
served before the rest has been imported (`early_server`).
"""
