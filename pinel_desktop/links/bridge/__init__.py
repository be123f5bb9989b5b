"""The HTTP link of the original PINEL: an external simulator or robot requests velocities and posts its pose.

`http_server.py` speaks HTTP, `request_guard.py` admits requests and `routes.py` dispatches them. `bridge_session.py`
holds the velocity and the pose. `transport.py` makes the transport of a real robot from these parts. docs/bridge.md
describes the routes.
"""
