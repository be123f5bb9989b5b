robot.move_forward(robot.lidar(0) - 0.7)
