"""What became of runs: their list, where the robot truly was, what the simulator predicted, clouds of 50 robots."""
