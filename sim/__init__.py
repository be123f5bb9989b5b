"""2D physics simulator: worlds, the robot's body, stepping. Imports nothing of the application."""
