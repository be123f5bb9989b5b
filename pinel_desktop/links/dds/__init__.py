"""ROS 2 robots without an installed ROS, over Cyclone DDS.

Importing this package imports nothing; `transport.py` loads the DDS library.
"""
