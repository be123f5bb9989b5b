"""A program on a real rclpy, run by the Python of an installed ROS 2: `python3 rclpy_robot.py DOMAIN JSON`.

JSON says what it does; without any it is a robot:
    node: its name; "" for that of the node which publishes `cmd_vel` now.
    hears: subscribes to `cmd_vel`, and follows it at once as a unicycle.
    durability: of that subscription, `volatile` or `transient_local`.
    deadline_s: within which each next command must come, as that subscription asks; none with null.
    tells: publishes `odom`, `scan` and `battery_state`.
    drives: publishes this velocity on `cmd_vel`, m/s and rad/s, ten times a second.
    offers: has a publisher of `cmd_vel` that says nothing.
    localisation: type of the poses of its own localisation, on `amcl_pose` in the frame `map`, 1 m ahead of its
        odometry; "" for none.
    turned_rad: what its odometry says of its heading beside the truth.

It prints a line for each velocity that comes. A line on its standard input changes what it does; it ends with that.
"""

import json
import math
import sys
import threading
import time

import rclpy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Odometry
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import BatteryState, LaserScan

PERIOD_S = 0.02
SEARCH_S = 10.0
ROBOT = {
    "node": "robot",
    "hears": True,
    "durability": "volatile",
    "deadline_s": None,
    "tells": True,
    "drives": None,
    "offers": False,
    "localisation": "",
    "turned_rad": 0.0,
}
LOCALISATIONS = {
    "PoseStamped": PoseStamped,
    "PoseWithCovarianceStamped": PoseWithCovarianceStamped,
}


class Robot:
    def __init__(self, node, behaviour):
        self._node, self.behaviour = node, behaviour
        self._x = self._y = self._yaw = self._v = self._omega = 0.0
        self._at_s = time.monotonic()
        if behaviour["tells"]:
            self._odometry = node.create_publisher(Odometry, "odom", 10)
            self._scan = node.create_publisher(LaserScan, "scan", 10)
            kind = LOCALISATIONS.get(behaviour["localisation"])
            self._localisation = kind and node.create_publisher(kind, "amcl_pose", 10)
            self._battery = node.create_publisher(BatteryState, "battery_state", 10)
            node.create_timer(PERIOD_S, self._report)
        if behaviour["hears"]:
            durability = DurabilityPolicy[behaviour["durability"].upper()]
            deadline = Duration(seconds=behaviour["deadline_s"] or 0)  # 0: none
            quality = QoSProfile(depth=10, durability=durability, deadline=deadline)
            node.create_subscription(Twist, "cmd_vel", self._receive, quality)
        if behaviour["drives"] or behaviour["offers"]:
            self._commands = node.create_publisher(Twist, "cmd_vel", 10)
            node.create_timer(0.1, self._drive)

    def _receive(self, message):
        self._advance()
        self._v, self._omega = message.linear.x, message.angular.z
        print(json.dumps([time.monotonic(), self._v, self._omega]), flush=True)

    def _drive(self):
        if self.behaviour["drives"]:
            message = Twist()
            message.linear.x, message.angular.z = self.behaviour["drives"]
            self._commands.publish(message)

    def _advance(self):
        now_s = time.monotonic()
        dt_s, self._at_s = now_s - self._at_s, now_s
        middle = self._yaw + self._omega * dt_s / 2
        self._x += self._v * dt_s * math.cos(middle)
        self._y += self._v * dt_s * math.sin(middle)
        self._yaw += self._omega * dt_s

    def _report(self):
        self._advance()
        yaw = self._yaw + self.behaviour["turned_rad"]
        message = Odometry()
        message.header.frame_id = "odom"
        message.header.stamp = self._node.get_clock().now().to_msg()
        message.pose.pose.position.x, message.pose.pose.position.y = self._x, self._y
        message.pose.pose.orientation.z = math.sin(yaw / 2)
        message.pose.pose.orientation.w = math.cos(yaw / 2)
        message.twist.twist.linear.x, message.twist.twist.angular.z = self._v, self._omega
        self._odometry.publish(message)
        if self._localisation:
            self._localise(message)
        scan = LaserScan()
        scan.angle_min, scan.angle_increment = -math.pi / 2, math.pi / 180
        scan.range_min, scan.range_max = 0.1, 8.0
        scan.ranges = [1.25] * 181
        self._scan.publish(scan)
        self._battery.publish(BatteryState(percentage=0.75))

    def _localise(self, odometry):
        message = LOCALISATIONS[self.behaviour["localisation"]]()
        message.header.stamp, message.header.frame_id = odometry.header.stamp, "map"
        pose = message.pose
        if self.behaviour["localisation"] == "PoseWithCovarianceStamped":
            pose.covariance[0] = pose.covariance[7] = 0.0004
            pose.covariance[35] = 0.0009
            pose = pose.pose
        pose.position.x, pose.position.y = 1.0 + self._x, self._y
        pose.orientation = odometry.pose.pose.orientation
        self._localisation.publish(message)


def name_of_the_driver(context):
    """The name of the node that publishes commands now."""
    node = rclpy.create_node("looks", context=context)
    due_s = time.monotonic() + SEARCH_S
    while not (found := node.get_publishers_info_by_topic("/cmd_vel")):
        assert time.monotonic() < due_s, "nobody drives"
        time.sleep(0.05)
    node.destroy_node()
    return found[0].node_name


def main():
    behaviour = {**ROBOT, **json.loads(sys.argv[2])}
    context = Context()
    rclpy.init(context=context, domain_id=int(sys.argv[1]))
    node = rclpy.create_node(behaviour["node"] or name_of_the_driver(context), context=context)
    robot = Robot(node, behaviour)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin)
    print("ready", flush=True)  # the first line, before any velocity
    spinning.start()
    for line in sys.stdin:
        behaviour.update(json.loads(line))
    executor.shutdown()
    spinning.join()
    del robot
    node.destroy_node()
    rclpy.shutdown(context=context)


if __name__ == "__main__":
    main()
