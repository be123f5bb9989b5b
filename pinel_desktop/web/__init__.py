"""The HTTP interface: page, API and event stream. Gets all it works with from `app` as `Services`."""

from pinel_desktop.web.application import create_app
from pinel_desktop.web.services import Services

__all__ = ["Services", "create_app"]
