"""A ROS 2 node that drives a robot for PINEL. Run by the Python of an installed ROS, which is not that of PINEL.

    python3 node.py CONFIGURATION

CONFIGURATION is a JSON object: `command_topic`, `odometry_topic`, `battery_topic` (full names; "" for none),
`domain` and `holder`, which is part of the name of the node.
Standard input brings JSON lines `{"twist": [m/s, rad/s]}`; when it ends, or brings nothing for 0.3 s, the robot stands.
Standard output gives JSON lines, each with a `type`: `ready`, `odometry`, `battery`, or `problem` (code and params).
It uses the standard library and rclpy only, and works with Python 3.8, that of Foxy.
"""

import json
import sys
import threading
import time

import rclpy
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import BatteryState

SEARCH_S = 5.0
POLL_S = 0.05
STALE_S = 0.3
WATCH_S = 0.5
COMMANDS = {"geometry_msgs/msg/Twist": Twist, "geometry_msgs/msg/TwistStamped": TwistStamped}
ODOMETRIES = {"nav_msgs/msg/Odometry": Odometry, "geometry_msgs/msg/PoseStamped": PoseStamped}
NEWEST = QoSProfile(
    depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.RELIABLE
)
# a best-effort subscription matches every publisher
ANY = QoSProfile(
    depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.BEST_EFFORT
)

_writing = threading.Lock()


class RefusalError(Exception):
    """Something that the app tells a person: a code and its parameters."""

    def __init__(self, code, **params):
        super().__init__(code)
        self.code, self.params = code, params


def say(kind, **fields):
    """Writes a line; safe from any thread. Raises OSError when the app has gone."""
    with _writing:
        sys.stdout.write(json.dumps({"type": kind, **fields}) + "\n")
        sys.stdout.flush()


class Drive:
    """Publishers and subscriptions of one robot."""

    def __init__(self, node, configuration):
        self._node, self._configuration = node, configuration
        self._command_topic = "/" + configuration["command_topic"]
        self._odometry_topic = "/" + configuration["odometry_topic"]
        self._publisher, self._type = None, None
        self._heard_s = time.monotonic()

    def open(self):
        """Finds the robot's topics and connects with them. Raises RefusalError."""
        self.require_nobody_else()
        self._type = self._found(
            self._command_topic, COMMANDS, self._node.get_subscriptions_info_by_topic
        )
        odometry = self._found(
            self._odometry_topic, ODOMETRIES, self._node.get_publishers_info_by_topic
        )
        self._publisher = self._node.create_publisher(self._type, self._command_topic, NEWEST)
        take = take_odometry if odometry is Odometry else take_pose
        self._node.create_subscription(odometry, self._odometry_topic, take, ANY)
        if self._configuration.get("battery_topic"):
            topic = "/" + self._configuration["battery_topic"]
            self._node.create_subscription(BatteryState, topic, take_battery, ANY)
        self._wait(lambda: self._publisher.get_subscription_count() > 0, self._command_topic)
        self.require_nobody_else()

    def _found(self, topic, known, endpoints):
        """The message type that the robot uses on a topic."""
        self._wait(lambda: endpoints(topic), topic)
        types = [endpoint.topic_type for endpoint in endpoints(topic)]
        for name in types:
            if name in known:
                return known[name]
        raise RefusalError(
            "robot_wrong_type", topic=topic, found=", ".join(types), wanted=", ".join(known)
        )

    def _wait(self, is_there, topic):
        due_s = time.monotonic() + SEARCH_S
        while not is_there():
            if time.monotonic() > due_s:
                raise RefusalError(
                    "robot_not_found", topic=topic, domain=self._configuration["domain"]
                )
            time.sleep(POLL_S)

    def require_nobody_else(self):
        """Raises RefusalError where another node commands the robot."""
        listeners = self._node.get_subscriptions_info_by_topic(self._command_topic)
        # what listens to commands and passes them on is the robot, as ros1_bridge
        ours = {self._node.get_name(), *(endpoint.node_name for endpoint in listeners)}
        for endpoint in self._node.get_publishers_info_by_topic(self._command_topic):
            if endpoint.node_name not in ours:
                raise RefusalError(
                    "robot_held", topic=self._command_topic, holder=endpoint.node_name
                )

    def send(self, v, omega):
        """Publishes a velocity."""
        message = self._type()
        twist = message
        if self._type is TwistStamped:
            message.header.stamp = self._node.get_clock().now().to_msg()
            twist = message.twist
        twist.linear.x, twist.angular.z = float(v), float(omega)
        self._publisher.publish(message)

    def hear(self, line):
        """Follows a line of the app."""
        v, omega = json.loads(line)["twist"]
        self._heard_s = time.monotonic()
        self.send(v, omega)

    def watch(self, ending):
        """Until the end: stops a robot whose app is silent, and tells of others that command it."""
        checked_s = time.monotonic()
        while not ending.wait(POLL_S):
            now_s = time.monotonic()
            if now_s - self._heard_s > STALE_S:
                self.send(0.0, 0.0)
            if now_s - checked_s > WATCH_S:
                checked_s = now_s
                try:
                    self.require_nobody_else()
                except RefusalError as refusal:
                    say("problem", code=refusal.code, params=refusal.params)


def seconds(stamp):
    return stamp.sec + stamp.nanosec * 1e-9


def take_odometry(message):
    pose, twist = message.pose.pose, message.twist.twist
    velocity = [twist.linear.x, twist.angular.z]
    say_pose(pose, velocity, message.header)


def take_pose(message):
    say_pose(message.pose, [None, None], message.header)


def say_pose(pose, velocity, header):
    q = pose.orientation
    say(
        "odometry",
        position=[pose.position.x, pose.position.y],
        orientation=[q.x, q.y, q.z, q.w],
        velocity=velocity,
        stamp=seconds(header.stamp),
        frame=header.frame_id,
    )


def take_battery(message):
    say("battery", level=message.percentage)


def run(configuration, context):
    """Drives until the input ends."""
    node = rclpy.create_node(f"pinel_{configuration['holder']}", context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin)
    spinning.start()
    ending = threading.Event()
    watching = None
    try:
        drive = Drive(node, configuration)
        drive.open()
        say("ready")
        watching = threading.Thread(target=drive.watch, args=(ending,))
        watching.start()
        for line in sys.stdin:
            drive.hear(line)
        for _ in range(5):
            drive.send(0.0, 0.0)
            time.sleep(0.02)
    except RefusalError as refusal:
        say("problem", code=refusal.code, params=refusal.params)
    finally:
        # this order: without the join, the end of the context aborts the process
        ending.set()
        if watching is not None:
            watching.join()
        executor.shutdown()
        spinning.join()
        node.destroy_node()


def main():
    configuration = json.loads(sys.argv[1])
    context = Context()
    rclpy.init(context=context, domain_id=configuration["domain"])
    try:
        run(configuration, context)
    finally:
        rclpy.shutdown(context=context)


if __name__ == "__main__":
    main()
