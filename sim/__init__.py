"""2D physics simulator: worlds, the robot's body, stepping. A leaf: imports nothing of the application."""
