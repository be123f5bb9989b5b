"""The link over HTTP of the original PINEL: an external simulator or robot asks for velocities and posts its pose.

`listener.py` speaks HTTP, `routes.py` judges requests, `exchange.py` holds what the two sides tell each other,
`transport.py` makes a robot's transport of them. docs/bridge.md describes the routes.
"""
