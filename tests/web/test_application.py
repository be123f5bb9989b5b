"""The WSGI application matches addresses; it builds none."""

from typing import cast

import pytest

from pinel_desktop.web.application import create_app
from pinel_desktop.web.services import Services


def test_routes_match_addresses_and_compile_nothing_to_build_them() -> None:
    adapter = create_app(cast(Services, object())).url_map.bind("127.0.0.1")
    endpoint, values = adapter.match("/api/runs/r1", "GET")
    assert values == {"id": "r1"}
    with pytest.raises(NotImplementedError):
        adapter.build(endpoint, values)
