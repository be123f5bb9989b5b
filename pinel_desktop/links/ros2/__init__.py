"""Robots of ROS 2, by the ROS that is installed on this PC."""
