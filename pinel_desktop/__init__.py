"""PINEL Desktop: block programs drive a Pioneer 3-DX in a simulator or over ROS 2."""

__version__ = "0.1.0"
