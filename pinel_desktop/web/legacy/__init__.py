"""The HTTP interface of the original PINEL, beside `/bridge/*`, which the engine answers itself (docs/bridge.md).

The engine owns the listening socket and forwards requests as messages (`runs/bridge.py`); `api.py` answers them. Calls
in quick succession are one run: `open_run.py` executes them, `run_store.py` stores the program of all their commands.
"""
