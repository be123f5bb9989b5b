"""The WSGI application: what its start costs."""

from typing import Any

import pytest
from werkzeug.routing import Rule

from pinel_desktop.web.application import create_app


def test_no_route_compiles_the_functions_that_would_tell_its_address(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """They take longer than all the rest of the application's start, and nothing asks a route for its address."""
    compiled: list[str] = []
    monkeypatch.setattr(Rule, "_get_func_code", lambda code, name: compiled.append(name))
    services: Any = None
    assert [*create_app(services).url_map.iter_rules()]
    assert not compiled
