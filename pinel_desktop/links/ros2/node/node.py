"""A ROS 2 node that drives a robot for PINEL. It runs in the Python of an installed ROS, not in the Python of PINEL.

    python3 node.py CONFIGURATION

CONFIGURATION is a JSON object:

- `command_topic`, `odometry_topic`, `scan_topic`, `sonar_topic`, `bumper_topic`, `battery_topic`, `localisation_topic`:
  full topic names, or "" for none;
- `domain`: the ROS_DOMAIN_ID;
- `holder`: part of the node's name;
- `drives`: if false, the node only listens.

Standard input has JSON lines `{"twist": [m/s, rad/s]}`. If no line arrives for 0.3 s, or at its end, the node sends
zeros. If the input ends during the search for the robot, the node exits at once.

Standard output has JSON lines, each with a `type`: `imported` (rclpy), `ready`, `odometry`, `scan`, `range`,
`points`, `bumper`, `battery`, `localised`, `published` and `withdrawn` (with the name of a sensor), `problem` (with
code and params). A node that only listens also writes `holder` (name of the node that drives the robot, or null). An
app that does not read blocks nothing: of each type only the newest line is queued.

The node uses only the standard library and rclpy. It must work with Python 3.8, the version of ROS 2 Foxy.
"""

import json
import sys
import threading
import time

import rclpy
import sensor_msgs.msg
from command_claim import PINEL, CommandClaim, RefusalError
from drivers import FINAL_ZEROS_S, LOST_TIMEOUT_S, UNMATCHED_TIMEOUT_S
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from inbox import Inbox
from localisation import Localisation
from nav_msgs.msg import Odometry
from outbox import Outbox
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool

SEARCH_S = 5.0
POLL_S = 0.05
COMMAND_TIMEOUT_S = 0.3
WATCH_S = 0.2
N_LAST_ZEROS = 5
COMMANDS = {"geometry_msgs/msg/Twist": Twist, "geometry_msgs/msg/TwistStamped": TwistStamped}
ODOMETRIES = {"nav_msgs/msg/Odometry": Odometry, "geometry_msgs/msg/PoseStamped": PoseStamped}
NEWEST = QoSProfile(
    depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.RELIABLE
)
# For a robot that matches only transient-local publishers. If it connects late, it receives the
# last velocity, unless that has expired.
NEWEST_TRANSIENT_LOCAL = QoSProfile(
    depth=1,
    history=HistoryPolicy.KEEP_LAST,
    reliability=ReliabilityPolicy.RELIABLE,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    lifespan=Duration(nanoseconds=int(COMMAND_TIMEOUT_S * 1e9)),
)
# a best-effort subscription matches every publisher
ANY = QoSProfile(
    depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.BEST_EFFORT
)
# A robot with a ring of sonars publishes all of their readings at once on one topic.
RING = QoSProfile(
    depth=32, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.BEST_EFFORT
)


class EndedError(Exception):
    """The input ended before the robot was found."""


class RobotConnection:
    """Publishers and subscriptions of one robot. The event `ended` aborts every wait."""

    def __init__(self, node, configuration, outbox, ended):
        self._node, self._configuration, self._outbox = node, configuration, outbox
        self._ended = ended
        self._command_topic = "/" + configuration["command_topic"]
        self._odometry_topic = "/" + configuration["odometry_topic"]
        self._publisher, self._type = None, None
        self._drives = configuration.get("drives", True)
        self._messages = Messages(outbox)
        self._sensors = Sensors(node, configuration, self._messages, outbox)
        self._localisation = Localisation(node, configuration, outbox, ANY)
        self._last_command_s, self._unmatched_since_s = time.monotonic(), None
        self._claim = CommandClaim(node, self._command_topic, self._odometry_topic)

    def open(self):
        """Searches the robot's topics and connects with them. Raises RefusalError and EndedError."""
        if self._drives:
            self._wait(self._claim.is_free, self._claim.problem)
        self._type = self._message_type(
            self._command_topic, COMMANDS, self._node.get_subscriptions_info_by_topic
        )
        odometry = self._message_type(
            self._odometry_topic, ODOMETRIES, self._node.get_publishers_info_by_topic
        )
        messages = self._messages
        callback = messages.on_odometry if odometry is Odometry else messages.on_pose
        self._node.create_subscription(odometry, self._odometry_topic, callback, ANY)
        self._sensors.poll()
        self._localisation.poll()
        if self._drives:
            self._publish()

    def _publish(self):
        """Creates the publisher, which shows other programs that this node drives the robot."""
        topic = self._command_topic
        listeners = self._node.get_subscriptions_info_by_topic(topic)
        durabilities = {listener.qos_profile.durability for listener in listeners}
        is_transient_local = DurabilityPolicy.TRANSIENT_LOCAL in durabilities
        quality = NEWEST_TRANSIENT_LOCAL if is_transient_local else NEWEST
        self._publisher = self._node.create_publisher(self._type, topic, quality)
        self._claim.announce()
        self._wait(self._has_subscriber, self._unmatched_problem)
        while not self._claim.check_claim():
            self._pause()

    def _has_subscriber(self):
        return self._publisher.get_subscription_count() > 0

    def _message_type(self, topic, known, endpoints):
        """Waits for a topic's endpoints and returns the message type that the robot uses."""
        self._wait(lambda: endpoints(topic), lambda: self._missing(topic))
        types = [endpoint.topic_type for endpoint in endpoints(topic)]
        for name in types:
            if name in known:
                return known[name]
        raise RefusalError(
            "robot_wrong_type", topic=topic, found=", ".join(types), wanted=", ".join(known)
        )

    def _wait(self, is_there, problem):
        """Waits until `is_there` returns True. After `SEARCH_S` raises the error that `problem` returns."""
        due_s = time.monotonic() + SEARCH_S
        while not is_there():
            if time.monotonic() > due_s:
                raise problem()
            self._pause()

    def _missing(self, topic):
        return RefusalError("robot_not_found", topic=topic, domain=self._configuration["domain"])

    def _unmatched_problem(self):
        return RefusalError("robot_deaf", topic=self._command_topic)

    def _pause(self):
        if self._ended.wait(POLL_S):
            raise EndedError()

    def _require_subscriber(self):
        """Raises RefusalError if the command topic has had no subscriber for `UNMATCHED_TIMEOUT_S`."""
        if self._has_subscriber():
            self._unmatched_since_s = None
            return
        now_s = time.monotonic()
        self._unmatched_since_s = self._unmatched_since_s or now_s
        if now_s - self._unmatched_since_s > UNMATCHED_TIMEOUT_S:
            raise self._unmatched_problem()

    def send(self, v, omega):
        """Publishes a velocity: zeros while another node also drives, nothing if this node only listens."""
        if self._publisher is None:
            return
        if self._claim.is_disputed:
            v = omega = 0.0
        message = self._type()
        twist = message
        if self._type is TwistStamped:
            message.header.stamp = self._node.get_clock().now().to_msg()
            twist = message.twist
        twist.linear.x, twist.angular.z = float(v), float(omega)
        self._publisher.publish(message)

    def send_last_zeros(self):
        """Sends the last zeros. If the odometry has stopped, continues for up to `FINAL_ZEROS_S`."""
        due_s, n_sent = time.monotonic() + FINAL_ZEROS_S, 0
        while n_sent < N_LAST_ZEROS or (self._is_lost() and time.monotonic() < due_s):
            self.send(0.0, 0.0)
            n_sent += 1
            time.sleep(0.02)

    def _is_lost(self):
        last_pose_s = self._messages.last_pose_s
        return last_pose_s is not None and time.monotonic() - last_pose_s > LOST_TIMEOUT_S

    def handle_line(self, line):
        """Sends the velocity of a line of the app."""
        v, omega = json.loads(line)["twist"]
        self._last_command_s = time.monotonic()
        self.send(v, omega)

    def watch(self):
        """Watches until the input ends: sends zeros once commands have expired, and polls the ROS graph."""
        checked_s = time.monotonic()
        while not self._ended.wait(POLL_S):
            now_s = time.monotonic()
            if now_s - self._last_command_s > COMMAND_TIMEOUT_S:
                self.send(0.0, 0.0)
            if now_s - checked_s > WATCH_S:
                checked_s = now_s
                self._poll_graph()

    def _poll_graph(self):
        self._sensors.poll()
        self._localisation.poll()
        if not self._drives:
            self._outbox.put("holder", name=self._claim.holder())
            return
        try:
            self._claim.require_alone()
            self._require_subscriber()
        except RefusalError as refusal:
            report_problem(self._outbox, refusal)


class Sensors:
    """Subscriptions to the robot's sensors; subscribes to each topic once the robot publishes it."""

    KINDS = (
        ("scan_topic", "lidar", ("LaserScan",)),
        ("sonar_topic", "sonar", ("Range", "PointCloud")),
        ("bumper_topic", "bumper", ("Bool",)),
        ("battery_topic", "battery", ("BatteryState",)),
    )

    def __init__(self, node, configuration, messages, outbox):
        self._node, self._messages, self._outbox = node, messages, outbox
        self._waiting = [
            ("/" + configuration[field], sensor, kinds)
            for field, sensor, kinds in self.KINDS
            if configuration.get(field)
        ]
        self._topics, self._withdrawn = {}, set()

    def poll(self):
        """Subscribes to new sensor topics, and reports topics that have no publisher any more."""
        for row in list(self._waiting):
            topic, sensor, kinds = row
            kind = next((kind for kind in kinds if self._is_published(topic, kind)), None)
            if kind is not None:
                self._waiting.remove(row)
                self._topics[sensor] = topic
                self._subscribe(topic, kind)
                self._outbox.put("published", sensor, sensor=sensor)
        for sensor, topic in self._topics.items():
            if self._node.get_publishers_info_by_topic(topic):
                self._withdrawn.discard(sensor)
            elif sensor not in self._withdrawn:
                self._withdrawn.add(sensor)
                self._outbox.drop(sensor)  # else a queued battery level would follow this line
                self._outbox.put("withdrawn", sensor, sensor=sensor)

    def _is_published(self, topic, kind):
        types = {endpoint.topic_type for endpoint in self._node.get_publishers_info_by_topic(topic)}
        package = "std_msgs" if kind == "Bool" else "sensor_msgs"
        return f"{package}/msg/{kind}" in types and message_type(kind) is not None

    def _subscribe(self, topic, kind):
        callback = getattr(self._messages, "on_" + kind.lower())
        quality = RING if kind == "Range" else ANY
        self._node.create_subscription(message_type(kind), topic, callback, quality)


def message_type(kind):
    """Returns the class of a message; None if this ROS release does not have it any more."""
    return Bool if kind == "Bool" else getattr(sensor_msgs.msg, kind, None)


class Messages:
    """Turns messages of the robot into lines for the app.

    Attributes:
        last_pose_s: arrival time of the newest odometry message (monotonic clock); None before the first.
    """

    def __init__(self, outbox):
        self._put = outbox.put
        self.last_pose_s = None

    def on_odometry(self, message):
        twist = message.twist.twist
        self._put_pose(message.pose.pose, [twist.linear.x, twist.angular.z], message.header)

    def on_pose(self, message):
        self._put_pose(message.pose, [None, None], message.header)

    def _put_pose(self, pose, velocity, header):
        self.last_pose_s = time.monotonic()
        q = pose.orientation
        self._put(
            "odometry",
            position=[pose.position.x, pose.position.y],
            orientation=[q.x, q.y, q.z, q.w],
            velocity=velocity,
            stamp=header.stamp.sec + header.stamp.nanosec * 1e-9,
            frame=header.frame_id,
        )

    def on_laserscan(self, message):
        self._put(
            "scan",
            first=message.angle_min,
            step=message.angle_increment,
            bounds=[message.range_min, message.range_max],
            ranges=[round(float(found), 3) for found in message.ranges],
        )

    def on_range(self, message):
        frame = message.header.frame_id
        self._put("range", frame, frame=frame, range=message.range, longest=message.max_range)

    def on_pointcloud(self, message):
        points = [[round(float(point.x), 3), round(float(point.y), 3)] for point in message.points]
        self._put("points", points=points)

    def on_bool(self, message):
        self._put("bumper", pressed=bool(message.data))

    def on_batterystate(self, message):
        self._put("battery", level=message.percentage)


def report_problem(outbox, refusal):
    outbox.put("problem", refusal.code, code=refusal.code, params=refusal.params)


def run(configuration, context, outbox, inbox):
    """Runs the node until the input ends."""
    node = rclpy.create_node(PINEL + configuration["holder"], context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin)
    spinning.start()
    try:
        connection = RobotConnection(node, configuration, outbox, inbox.ended)
        connection.open()
        outbox.put("ready")
        inbox.follow(connection.handle_line)
        connection.watch()
        connection.send_last_zeros()
    except RefusalError as refusal:
        report_problem(outbox, refusal)
    except EndedError:
        pass  # nothing was sent to the robot
    finally:
        # The join must come first: without it, the shutdown of the context aborts the process.
        executor.shutdown()
        spinning.join()
        node.destroy_node()


def main():
    outbox, inbox = Outbox(), Inbox()
    outbox.put("imported")
    configuration = json.loads(sys.argv[1])
    context = Context()
    rclpy.init(context=context, domain_id=configuration["domain"])
    try:
        run(configuration, context, outbox, inbox)
    finally:
        rclpy.shutdown(context=context)
        outbox.close()


if __name__ == "__main__":
    main()
