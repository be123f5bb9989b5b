"""ROS 2 robots, over a node that runs in the ROS installed on this PC."""
