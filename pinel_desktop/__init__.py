"""PINEL Desktop: block programs drive a Pioneer 3-DX in a simulator or over ROS 2."""

import os

__version__ = "0.2.0"

# pydantic would search all installed packages for plugins at every start; PINEL has none
os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
