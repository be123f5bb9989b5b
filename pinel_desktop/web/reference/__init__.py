"""docs/http-api.md and docs/events.md, made from the OpenAPI description and the declared events.

`python -m pinel_desktop.web.reference` writes both; a test holds them current.
"""
