"""A robot on a real rclpy, run by the Python of an installed ROS 2: `python3 rclpy_robot.py DOMAIN`.

A unicycle that follows `cmd_vel` at once and publishes `odom`, `scan` and `battery_state`. It prints a line for each
velocity, and ends with its input.
"""

import json
import math
import sys
import threading
import time

import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from sensor_msgs.msg import BatteryState, LaserScan

PERIOD_S = 0.02


class Robot:
    def __init__(self, node):
        self._node = node
        self._x = self._y = self._yaw = self._v = self._omega = 0.0
        self._at_s = time.monotonic()
        self._odometry = node.create_publisher(Odometry, "odom", 10)
        self._scan = node.create_publisher(LaserScan, "scan", 10)
        self._battery = node.create_publisher(BatteryState, "battery_state", 10)
        node.create_subscription(Twist, "cmd_vel", self._hear, 10)
        node.create_timer(PERIOD_S, self._report)

    def _hear(self, message):
        self._go_on()
        self._v, self._omega = message.linear.x, message.angular.z
        print(json.dumps([time.monotonic(), self._v, self._omega]), flush=True)

    def _go_on(self):
        now_s = time.monotonic()
        dt_s, self._at_s = now_s - self._at_s, now_s
        middle = self._yaw + self._omega * dt_s / 2
        self._x += self._v * dt_s * math.cos(middle)
        self._y += self._v * dt_s * math.sin(middle)
        self._yaw += self._omega * dt_s

    def _report(self):
        self._go_on()
        message = Odometry()
        message.header.frame_id = "odom"
        message.header.stamp = self._node.get_clock().now().to_msg()
        message.pose.pose.position.x, message.pose.pose.position.y = self._x, self._y
        message.pose.pose.orientation.z = math.sin(self._yaw / 2)
        message.pose.pose.orientation.w = math.cos(self._yaw / 2)
        message.twist.twist.linear.x, message.twist.twist.angular.z = self._v, self._omega
        self._odometry.publish(message)
        scan = LaserScan()
        scan.angle_min, scan.angle_increment = -math.pi / 2, math.pi / 180
        scan.range_min, scan.range_max = 0.1, 8.0
        scan.ranges = [1.25] * 181
        self._scan.publish(scan)
        self._battery.publish(BatteryState(percentage=0.75))


def main():
    context = Context()
    rclpy.init(context=context, domain_id=int(sys.argv[1]))
    node = rclpy.create_node("robot", context=context)
    robot = Robot(node)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin)
    spinning.start()
    print("ready", flush=True)
    sys.stdin.read()
    executor.shutdown()
    spinning.join()
    del robot
    node.destroy_node()
    rclpy.shutdown(context=context)


if __name__ == "__main__":
    main()
