"""Robots of ROS 2 without an installed ROS, over Cyclone DDS.

Importing this package imports nothing; `transport.py` loads the DDS library.
"""
