"""The HTTP interface of the original PINEL, beside `/bridge/*`, which the engine answers itself (docs/bridge.md).

The engine keeps the listener and hands requests on as messages (`runs/bridge.py`): `api.py` answers them. Calls that
follow one another soon are one run: `open_run.py` carries them out, `keeping.py` keeps the program that they add up to.
"""
