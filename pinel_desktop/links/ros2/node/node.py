"""A ROS 2 node that drives a robot for PINEL. Run by the Python of an installed ROS, which is not that of PINEL.

    python3 node.py CONFIGURATION

CONFIGURATION is a JSON object: `command_topic`, `odometry_topic`, `scan_topic`, `sonar_topic`, `bumper_topic`,
`battery_topic` (full names; "" for none), `domain`, `holder`, which is part of the name of the node, and `drives`:
without it the node only listens.
Standard input brings JSON lines `{"twist": [m/s, rad/s]}`; when it ends, or brings nothing for 0.3 s, the robot stands.
It is read from the start: a node whose input ends while it searches ends at once.
Standard output gives JSON lines, each with a `type`: `begun` (ROS is there), `ready`, `odometry`, `scan`, `range`,
`points`, `bumper`, `battery`, `offered` and `gone` (a sensor), `problem` (code and params), or from a node that only
listens `holder` (the name of the node that drives the robot, or null). An app that does not read them holds up nobody:
of each kind the newest waits.
It uses the standard library and rclpy only, and works with Python 3.8, that of Foxy.
"""

import json
import sys
import threading
import time

import rclpy
import sensor_msgs.msg
from drivers import DEAF_S, LAST_S, SILENT_S
from geometry_msgs.msg import PoseStamped, Twist, TwistStamped
from holding import PINEL, Holding, RefusalError
from inbox import Inbox
from nav_msgs.msg import Odometry
from outbox import Outbox
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool

SEARCH_S = 5.0
POLL_S = 0.05
STALE_S = 0.3
WATCH_S = 0.2
N_LAST_ZEROS = 5
COMMANDS = {"geometry_msgs/msg/Twist": Twist, "geometry_msgs/msg/TwistStamped": TwistStamped}
ODOMETRIES = {"nav_msgs/msg/Odometry": Odometry, "geometry_msgs/msg/PoseStamped": PoseStamped}
NEWEST = QoSProfile(
    depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.RELIABLE
)
# for a robot that hears nobody else: a late one is told the last velocity, but none that has expired
NEWEST_KEPT = QoSProfile(
    depth=1,
    history=HistoryPolicy.KEEP_LAST,
    reliability=ReliabilityPolicy.RELIABLE,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    lifespan=Duration(nanoseconds=int(STALE_S * 1e9)),
)
# a best-effort subscription matches every publisher
ANY = QoSProfile(
    depth=1, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.BEST_EFFORT
)
# a robot with a ring of sonars tells all of them at once on one topic
RING = QoSProfile(
    depth=32, history=HistoryPolicy.KEEP_LAST, reliability=ReliabilityPolicy.BEST_EFFORT
)


class EndedError(Exception):
    """The input has ended before the robot was found."""


class Drive:
    """Publishers and subscriptions of one robot. What waits in it ends with the event `ended`."""

    def __init__(self, node, configuration, outbox, ended):
        self._node, self._configuration, self._outbox = node, configuration, outbox
        self._ended = ended
        self._command_topic = "/" + configuration["command_topic"]
        self._odometry_topic = "/" + configuration["odometry_topic"]
        self._publisher, self._type = None, None
        self._drives = configuration.get("drives", True)
        self._messages = Messages(outbox)
        self._sensors = Sensors(node, configuration, self._messages, outbox)
        self._heard_s, self._deaf_since_s = time.monotonic(), None
        self._holding = Holding(node, self._command_topic, self._odometry_topic)

    def open(self):
        """Finds the robot's topics and connects with them. Raises RefusalError and EndedError."""
        if self._drives:
            self._wait(self._holding.is_free, self._holding.problem)
        self._type = self._found(
            self._command_topic, COMMANDS, self._node.get_subscriptions_info_by_topic
        )
        odometry = self._found(
            self._odometry_topic, ODOMETRIES, self._node.get_publishers_info_by_topic
        )
        messages = self._messages
        take = messages.take_odometry if odometry is Odometry else messages.take_pose
        self._node.create_subscription(odometry, self._odometry_topic, take, ANY)
        self._sensors.look()
        if self._drives:
            self._publish()

    def _publish(self):
        """From here on others see who drives the robot."""
        topic = self._command_topic
        listeners = self._node.get_subscriptions_info_by_topic(topic)
        durabilities = {listener.qos_profile.durability for listener in listeners}
        keeps = DurabilityPolicy.TRANSIENT_LOCAL in durabilities
        quality = NEWEST_KEPT if keeps else NEWEST
        self._publisher = self._node.create_publisher(self._type, topic, quality)
        self._holding.start()
        self._wait(self._is_heard, self._deaf)
        while not self._holding.is_claimed():
            self._pause()

    def _is_heard(self):
        return self._publisher.get_subscription_count() > 0

    def _found(self, topic, known, endpoints):
        """The message type that the robot uses on a topic."""
        self._wait(lambda: endpoints(topic), lambda: self._missing(topic))
        types = [endpoint.topic_type for endpoint in endpoints(topic)]
        for name in types:
            if name in known:
                return known[name]
        raise RefusalError(
            "robot_wrong_type", topic=topic, found=", ".join(types), wanted=", ".join(known)
        )

    def _wait(self, is_there, problem):
        """Until something is there. Raises what `problem` gives when it does not come."""
        due_s = time.monotonic() + SEARCH_S
        while not is_there():
            if time.monotonic() > due_s:
                raise problem()
            self._pause()

    def _missing(self, topic):
        return RefusalError("robot_not_found", topic=topic, domain=self._configuration["domain"])

    def _deaf(self):
        return RefusalError("robot_deaf", topic=self._command_topic)

    def _pause(self):
        if self._ended.wait(POLL_S):
            raise EndedError()

    def _require_heard(self):
        """Raises RefusalError when nobody takes the commands any more."""
        if self._is_heard():
            self._deaf_since_s = None
            return
        now_s = time.monotonic()
        self._deaf_since_s = self._deaf_since_s or now_s
        if now_s - self._deaf_since_s > DEAF_S:
            raise self._deaf()

    def send(self, v, omega):
        """Publishes a velocity, zeros where somebody else is there, nothing where the node only listens."""
        if self._publisher is None:
            return
        if self._holding.is_disputed:
            v = omega = 0.0
        message = self._type()
        twist = message
        if self._type is TwistStamped:
            message.header.stamp = self._node.get_clock().now().to_msg()
            twist = message.twist
        twist.linear.x, twist.angular.z = float(v), float(omega)
        self._publisher.publish(message)

    def stand(self):
        """Sends the last zeros, and goes on for a while where the robot is silent."""
        due_s, n_sent = time.monotonic() + LAST_S, 0
        while n_sent < N_LAST_ZEROS or (self._is_lost() and time.monotonic() < due_s):
            self.send(0.0, 0.0)
            n_sent += 1
            time.sleep(0.02)

    def _is_lost(self):
        heard_s = self._messages.heard_s
        return heard_s is not None and time.monotonic() - heard_s > SILENT_S

    def hear(self, line):
        """Follows a line of the app."""
        v, omega = json.loads(line)["twist"]
        self._heard_s = time.monotonic()
        self.send(v, omega)

    def watch(self):
        """Until the end: stops a robot whose app is silent, tells of others that command it and of what vanishes."""
        checked_s = time.monotonic()
        while not self._ended.wait(POLL_S):
            now_s = time.monotonic()
            if now_s - self._heard_s > STALE_S:
                self.send(0.0, 0.0)
            if now_s - checked_s > WATCH_S:
                checked_s = now_s
                self._look_around()

    def _look_around(self):
        self._sensors.look()
        if not self._drives:
            self._outbox.say("holder", name=self._holding.holder())
            return
        try:
            self._holding.require_alone()
            self._require_heard()
        except RefusalError as refusal:
            tell(self._outbox, refusal)


class Sensors:
    """Subscriptions to the sensors that the robot publishes, as it comes to publish them."""

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
        self._found, self._gone = {}, set()

    def look(self):
        """Subscribes to what is new, and tells what nobody publishes any more."""
        for row in list(self._waiting):
            topic, sensor, kinds = row
            kind = next((kind for kind in kinds if self._is_published(topic, kind)), None)
            if kind is not None:
                self._waiting.remove(row)
                self._found[sensor] = topic
                self._subscribe(topic, kind)
                self._outbox.say("offered", sensor, sensor=sensor)
        for sensor, topic in self._found.items():
            if self._node.get_publishers_info_by_topic(topic):
                self._gone.discard(sensor)
            elif sensor not in self._gone:
                self._gone.add(sensor)
                self._outbox.drop(sensor)  # the level of a battery would come after this
                self._outbox.say("gone", sensor, sensor=sensor)

    def _is_published(self, topic, kind):
        types = {endpoint.topic_type for endpoint in self._node.get_publishers_info_by_topic(topic)}
        package = "std_msgs" if kind == "Bool" else "sensor_msgs"
        return f"{package}/msg/{kind}" in types and message_type(kind) is not None

    def _subscribe(self, topic, kind):
        take = getattr(self._messages, "take_" + kind.lower())
        quality = RING if kind == "Range" else ANY
        self._node.create_subscription(message_type(kind), topic, take, quality)


def message_type(kind):
    """None where this ROS has no such message any more."""
    return Bool if kind == "Bool" else getattr(sensor_msgs.msg, kind, None)


class Messages:
    """Turns messages of the robot into lines.

    Attributes:
        heard_s: when the newest one about its pose came (monotonic); None before the first.
    """

    def __init__(self, outbox):
        self._say = outbox.say
        self.heard_s = None

    def take_odometry(self, message):
        twist = message.twist.twist
        self._say_pose(message.pose.pose, [twist.linear.x, twist.angular.z], message.header)

    def take_pose(self, message):
        self._say_pose(message.pose, [None, None], message.header)

    def _say_pose(self, pose, velocity, header):
        self.heard_s = time.monotonic()
        q = pose.orientation
        self._say(
            "odometry",
            position=[pose.position.x, pose.position.y],
            orientation=[q.x, q.y, q.z, q.w],
            velocity=velocity,
            stamp=header.stamp.sec + header.stamp.nanosec * 1e-9,
            frame=header.frame_id,
        )

    def take_laserscan(self, message):
        self._say(
            "scan",
            first=message.angle_min,
            step=message.angle_increment,
            bounds=[message.range_min, message.range_max],
            ranges=[round(float(found), 3) for found in message.ranges],
        )

    def take_range(self, message):
        frame = message.header.frame_id
        self._say("range", frame, frame=frame, range=message.range, longest=message.max_range)

    def take_pointcloud(self, message):
        points = [[round(float(point.x), 3), round(float(point.y), 3)] for point in message.points]
        self._say("points", points=points)

    def take_bool(self, message):
        self._say("bumper", pressed=bool(message.data))

    def take_batterystate(self, message):
        self._say("battery", level=message.percentage)


def tell(outbox, refusal):
    outbox.say("problem", refusal.code, code=refusal.code, params=refusal.params)


def run(configuration, context, outbox, inbox):
    """Drives until the input ends."""
    node = rclpy.create_node(PINEL + configuration["holder"], context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin)
    spinning.start()
    try:
        drive = Drive(node, configuration, outbox, inbox.ended)
        drive.open()
        outbox.say("ready")
        inbox.follow(drive.hear)
        drive.watch()
        drive.stand()
    except RefusalError as refusal:
        tell(outbox, refusal)
    except EndedError:
        pass  # nothing was sent to the robot
    finally:
        # this order: without the join, the end of the context aborts the process
        executor.shutdown()
        spinning.join()
        node.destroy_node()


def main():
    outbox, inbox = Outbox(), Inbox()
    outbox.say("begun")
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
